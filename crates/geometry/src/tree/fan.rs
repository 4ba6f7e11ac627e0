//! Rays from one point that go almost the same way, as those of a camera do: they open
//! boxes together.

mod slopes;
mod together;

use super::Tree;
use super::batch::Batch;
use super::lanes::{Lanes, Triangles, greater};
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::Stack;
use super::turns::{Waiting, Way, take_turns};
use super::walk::{Visitor, ones, visit};
use crate::Ray;
use slopes::Slopes;
use std::array::from_fn;
use std::iter::Enumerate;
use std::ops::Range;
use std::slice::Chunks;
use together::fan;

/// So many fans at once are best where the tree does not fit into the cache of a core, and
/// where it does.
const MANY: usize = 4;
const FEW: usize = 2;

/// Rays in a fan.
const FAN: usize = 8;

/// Takes all fans among the rays to their leaves. The places of the rays that are left.
#[inline(always)]
pub(crate) fn walk_fans<'a, L: Lanes, T: Triangles, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&'a Ray) -> L,
    triangles: impl Fn(&'a Ray) -> T,
    batch: &mut B,
) -> Vec<Range<usize>> {
    let chunks = batch.rays().chunks(FAN).enumerate();
    let mut fans = Fans { root, lanes, triangles, chunks, left: Vec::new() };
    let count = if tree.is_cached() { FEW } else { MANY };
    take_turns(tree, count, batch, &mut fans);
    fans.left
}

/// Fans that wait.
struct Fans<'a, F, G> {
    root: Child,
    lanes: F,
    triangles: G,
    chunks: Enumerate<Chunks<'a, Ray>>,
    /// The places of rays that make no fan.
    left: Vec<Range<usize>>,
}

/// A fan under way.
struct Fan<L, T, V> {
    /// The number of its first ray.
    first: usize,
    current: Child,
    /// One bit for each ray that goes there.
    active: u32,
    slopes: Slopes,
    /// All rays before boxes, and each before triangles.
    all: L,
    each: [T; FAN],
    visitors: Visitors<V>,
}

impl<'a, L, T, B, F, G> Waiting<B, Fan<L, T, B::Visitor>> for Fans<'a, F, G>
where
    L: Lanes,
    T: Triangles,
    B: Batch<'a>,
    F: Fn(&'a Ray) -> L,
    G: Fn(&'a Ray) -> T,
{
    type Question = (usize, &'a [Ray; FAN]);

    /// The next fan and the number of its first ray.
    #[inline(always)]
    fn next(&mut self) -> Option<Self::Question> {
        for (chunk, rays) in &mut self.chunks {
            if let Some(rays) = fan(rays) {
                return Some((FAN * chunk, rays));
            }
            let places = FAN * chunk..FAN * chunk + rays.len();
            match self.left.last_mut().filter(|last| last.end == places.start) {
                Some(last) => last.end = places.end,
                None => self.left.push(places),
            }
        }
        None
    }

    #[inline(always)]
    fn begin(&self, (first, rays): Self::Question, batch: &B) -> Fan<L, T, B::Visitor> {
        let (all, each) = ((self.lanes)(&rays[0]), [(self.triangles)(&rays[0]); FAN]);
        let visitors = Visitors::new(from_fn(|i| batch.begin(first + i)));
        let slopes = Slopes::of(rays);
        let mut fan = Fan { first, current: self.root, active: 0, slopes, all, each, visitors };
        self.begin_anew((first, rays), batch, &mut fan);
        fan
    }

    /// A fan is made where it stays: to move it would take as long as to open a few boxes.
    #[inline(always)]
    fn begin_anew(
        &self,
        (first, rays): Self::Question,
        batch: &B,
        fan: &mut Fan<L, T, B::Visitor>,
    ) {
        fan.slopes = Slopes::of(rays);
        let [near, far] = fan.slopes.widest();
        fan.all = (self.lanes)(&rays[0]).with_slopes(near, far);
        for (each, ray) in fan.each.iter_mut().zip(rays) {
            *each = (self.triangles)(ray);
        }
        fan.visitors = Visitors::new(from_fn(|i| batch.begin(first + i)));
        fan.first = first;
        fan.current = self.root;
        fan.active = u32::MAX >> (32 - FAN);
    }
}

impl<'a, L: Lanes, T: Triangles, B: Batch<'a>> Way<B> for Fan<L, T, B::Visitor> {
    #[inline(always)]
    fn step(&mut self, tree: &Tree, ahead: &Ahead, stack: &mut Stack) -> bool {
        let Self { slopes, all, each, visitors, .. } = self;
        if let Content::Node(index) = self.current.open() {
            all.open(
                &tree.nodes[index],
                &Child::slots(index),
                visitors.limit,
                B::Visitor::IN_ORDER,
                stack,
            );
        } else {
            visitors.visit(tree, self.current, each, self.active);
        }
        while let Some((index, lane)) = stack.pop(visitors.limit).map(Child::slot) {
            let node = &tree.nodes[index];
            self.active = slopes.meet(node, lane, &visitors.limits);
            if self.active != 0 {
                self.current = node.children[lane];
                ahead.ask(self.current);
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn end(&self, batch: &mut B) {
        for (i, visitor) in self.visitors.each.iter().enumerate() {
            batch.end(self.first + i, visitor);
        }
    }
}

/// What the rays of a fan do in leaves.
struct Visitors<V> {
    each: [V; FAN],
    /// Below zero once a ray asks nothing more.
    limits: [f32; FAN],
    /// The farthest of them.
    limit: f32,
}

impl<V: Visitor> Visitors<V> {
    #[inline(always)]
    fn new(visitors: [V; FAN]) -> Self {
        let limits = from_fn(|i| visitors[i].limit());
        let mut this = Self { each: visitors, limits, limit: 0.0 };
        this.see_limits();
        this
    }

    #[inline(always)]
    fn see_limits(&mut self) {
        self.limit = self.limits.iter().fold(-1.0, |farthest, &limit| greater(limit, farthest));
    }

    /// Takes the rays that have a bit to a leaf.
    #[inline(always)]
    fn visit<T: Triangles>(&mut self, tree: &Tree, leaf: Child, each: &[T; FAN], active: u32) {
        for i in ones(active) {
            let visitor = &mut self.each[i % FAN];
            let is_done = visit(tree, leaf, &each[i % FAN], visitor).is_break();
            self.limits[i % FAN] = if is_done { -1.0 } else { visitor.limit() };
        }
        self.see_limits();
    }
}
