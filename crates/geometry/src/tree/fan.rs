//! Rays from one point that go almost the same way, as those of a camera do: they open
//! boxes and meet triangles together.

mod candidates;
mod exact;
mod fast;
mod rays;
pub(crate) mod sight;
mod slopes;

use super::Tree;
use super::batch::Batch;
use super::eights::{ALL, EIGHT, Eights};
use super::lanes::Lanes;
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::Stack;
use super::turns::{Waiting, Way, take_turns};
use super::visitor::{Visitor, Visitors};
use crate::Ray;
use rays::{Rays, fan};
use sight::Sight;
use slopes::Slopes;
use std::array::from_fn;
use std::iter::Enumerate;
use std::ops::Range;
use std::slice::Chunks;

/// So many fans at once are best where the tree fits into the cache of a core.
const FEW: usize = 2;

/// Takes all fans among the rays to their leaves. The places of the rays that are left.
#[inline(always)]
pub(crate) fn walk_fans<'a, L: Lanes, E: Eights, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&'a Ray) -> L,
    eights: E,
    batch: &mut B,
) -> Vec<Range<usize>> {
    let chunks = batch.rays().chunks(EIGHT).enumerate();
    let mut fans = Fans { tree, root, lanes, eights, chunks, left: Vec::new() };
    take_turns(tree, FEW, batch, &mut fans);
    fans.left
}

/// Fans that wait.
struct Fans<'a, 't, F, E> {
    tree: &'t Tree,
    root: Child,
    lanes: F,
    eights: E,
    chunks: Enumerate<Chunks<'a, Ray>>,
    /// The places of rays that make no fan.
    left: Vec<Range<usize>>,
}

/// A fan under way.
struct Fan<L, E: Eights, V> {
    /// The number of its first ray.
    first: usize,
    current: Child,
    /// One bit for each ray that goes there.
    active: u32,
    /// All rays before boxes, each before a box, and each before triangles.
    all: L,
    slopes: Slopes<E>,
    sight: Sight<E>,
    visitors: Visitors<V>,
}

impl<'a, L, E, B, F> Waiting<B, Fan<L, E, B::Visitor>> for Fans<'a, '_, F, E>
where
    L: Lanes,
    E: Eights,
    B: Batch<'a>,
    F: Fn(&'a Ray) -> L,
{
    type Question = (usize, &'a [Ray; EIGHT]);

    /// The next fan and the number of its first ray.
    #[inline(always)]
    fn next(&mut self) -> Option<Self::Question> {
        for (chunk, rays) in &mut self.chunks {
            if let Some(rays) = fan(self.eights, rays) {
                return Some((EIGHT * chunk, rays));
            }
            let places = EIGHT * chunk..EIGHT * chunk + rays.len();
            match self.left.last_mut().filter(|last| last.end == places.start) {
                Some(last) => last.end = places.end,
                None => self.left.push(places),
            }
        }
        None
    }

    #[inline(always)]
    fn begin(&self, (first, rays): Self::Question, batch: &B) -> Fan<L, E, B::Visitor> {
        let (ray, rays) = (&rays[0], Rays::of(self.eights, rays));
        let slopes = Slopes::of(&rays);
        let [near, far] = slopes.widest();
        Fan {
            first,
            current: self.root,
            active: ALL,
            all: (self.lanes)(ray).with_slopes(near, far),
            slopes,
            sight: Sight::of(&rays, self.tree.sizes),
            visitors: Visitors::new(self.eights, from_fn(|i| batch.begin(first + i))),
        }
    }

    /// Part by part: to move a whole fan takes longer.
    #[inline(always)]
    fn begin_anew(
        &self,
        (first, rays): Self::Question,
        batch: &B,
        fan: &mut Fan<L, E, B::Visitor>,
    ) {
        let (ray, rays) = (&rays[0], Rays::of(self.eights, rays));
        fan.slopes = Slopes::of(&rays);
        let [near, far] = fan.slopes.widest();
        fan.all = (self.lanes)(ray).with_slopes(near, far);
        fan.sight = Sight::of(&rays, self.tree.sizes);
        for (i, visitor) in fan.visitors.each.iter_mut().enumerate() {
            *visitor = batch.begin(first + i);
        }
        fan.visitors.see_limits(self.eights);
        (fan.first, fan.current, fan.active) = (first, self.root, ALL);
    }
}

impl<'a, L: Lanes, E: Eights, B: Batch<'a>> Way<B> for Fan<L, E, B::Visitor> {
    #[inline(always)]
    fn step(&mut self, tree: &Tree, ahead: &Ahead, stack: &mut Stack) -> bool {
        let Self { slopes, all, visitors, .. } = self;
        if let Content::Node(index) = self.current.open() {
            all.open(
                &tree.nodes[index],
                &Child::slots(index),
                visitors.limit,
                B::Visitor::IN_ORDER,
                stack,
            );
        } else {
            visitors.visit(tree, self.current, &self.sight, self.active);
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
