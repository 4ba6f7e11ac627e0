//! Many rays at a time.

use super::Tree;
use super::lanes::Lanes;
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::Stack;
use super::turns::{Waiting, Way, take_turns};
use super::visitor::Visitor;
use super::walk::visit;
use crate::Ray;
use std::ops::Range;
use std::vec::IntoIter;

/// So many rays at once are best where the tree fits into the cache of a core.
const FEW: usize = 4;

/// Questions about many rays, and where the answers go.
pub(crate) trait Batch<'a> {
    type Visitor: Visitor;

    fn rays(&self) -> &'a [Ray];

    /// What ray `index` asks of the leaves.
    fn begin(&self, index: usize) -> Self::Visitor;

    /// Takes the answer for ray `index`, once all its leaves have been visited.
    fn end(&mut self, index: usize, visitor: &Self::Visitor);
}

/// Takes the rays at these places to their leaves.
#[inline(always)]
pub(crate) fn walk_each<'a, L: Lanes, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&'a Ray) -> L,
    batch: &mut B,
    left: Vec<Range<usize>>,
) {
    let (rays, left) = (batch.rays(), left.into_iter());
    let mut singles = Singles { rays, root, lanes, left, places: 0..0 };
    take_turns(tree, FEW, batch, &mut singles);
}

/// Rays that wait.
struct Singles<'a, F> {
    rays: &'a [Ray],
    root: Child,
    lanes: F,
    left: IntoIter<Range<usize>>,
    /// The places that come before those.
    places: Range<usize>,
}

/// A ray under way.
struct Single<L, V> {
    index: usize,
    current: Child,
    lanes: L,
    visitor: V,
}

impl<'a, L, B, F> Waiting<B, Single<L, B::Visitor>> for Singles<'a, F>
where
    L: Lanes,
    B: Batch<'a>,
    F: Fn(&'a Ray) -> L,
{
    type Question = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        loop {
            match self.places.next() {
                Some(index) if self.rays[index].is_traceable() => return Some(index),
                Some(_) => {}
                None => self.places = self.left.next()?,
            }
        }
    }

    #[inline(always)]
    fn begin(&self, index: usize, batch: &B) -> Single<L, B::Visitor> {
        let (lanes, visitor) = ((self.lanes)(&self.rays[index]), batch.begin(index));
        Single { index, current: self.root, lanes, visitor }
    }

    #[inline(always)]
    fn begin_anew(&self, index: usize, batch: &B, way: &mut Single<L, B::Visitor>) {
        *way = self.begin(index, batch);
    }
}

impl<'a, L: Lanes, B: Batch<'a>> Way<B> for Single<L, B::Visitor> {
    #[inline(always)]
    fn step(&mut self, tree: &Tree, ahead: &Ahead, stack: &mut Stack) -> bool {
        let Self { current, lanes, visitor, .. } = self;
        if let Content::Node(index) = current.open() {
            let node = &tree.nodes[index];
            lanes.open(node, &node.children, visitor.limit(), B::Visitor::IN_ORDER, stack);
        } else if visit(tree, *current, lanes, visitor).is_break() {
            return false;
        }
        let Some(next) = stack.pop(visitor.limit()) else { return false };
        *current = next;
        ahead.ask(next);
        true
    }

    #[inline(always)]
    fn end(&self, batch: &mut B) {
        batch.end(self.index, &self.visitor);
    }
}
