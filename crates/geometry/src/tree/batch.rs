//! Many rays at a time.

use super::Tree;
use super::interleave::{InFlight, Queue, interleave};
use super::intersector::ChildIntersector;
use super::node::{Child, Content};
use super::prefetch::Prefetcher;
use super::stack::Stack;
use super::visitor::Visitor;
use super::walk::visit;
use crate::Ray;
use std::ops::Range;
use std::vec::IntoIter;

/// The number of rays at once that is best where the tree fits into the cache of a core.
const FEW: usize = 4;

/// Questions about many rays, and where the answers go.
pub(crate) trait Batch<'a> {
    type Visitor: Visitor;

    fn rays(&self) -> &'a [Ray];

    /// Returns the visitor of ray `index`.
    fn begin(&self, index: usize) -> Self::Visitor;

    /// Takes the answer for ray `index`, once all its leaves have been visited.
    fn end(&mut self, index: usize, visitor: &Self::Visitor);
}

/// Takes the rays at these places to their leaves.
#[inline(always)]
pub(crate) fn walk_each<'a, L: ChildIntersector, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    intersector: impl Fn(&'a Ray) -> L,
    batch: &mut B,
    left: Vec<Range<usize>>,
) {
    let (rays, left) = (batch.rays(), left.into_iter());
    let mut queue = SingleRays { rays, root, intersector, left, places: 0..0 };
    interleave(tree, FEW, batch, &mut queue);
}

/// Rays that wait to be traced one by one.
struct SingleRays<'a, F> {
    rays: &'a [Ray],
    root: Child,
    intersector: F,
    left: IntoIter<Range<usize>>,
    /// The places that come before those.
    places: Range<usize>,
}

/// A ray in flight.
struct RayInFlight<L, V> {
    index: usize,
    current: Child,
    intersector: L,
    visitor: V,
}

impl<'a, L, B, F> Queue<B, RayInFlight<L, B::Visitor>> for SingleRays<'a, F>
where
    L: ChildIntersector,
    B: Batch<'a>,
    F: Fn(&'a Ray) -> L,
{
    type Item = usize;

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
    fn begin(&self, index: usize, batch: &B) -> RayInFlight<L, B::Visitor> {
        let (intersector, visitor) = ((self.intersector)(&self.rays[index]), batch.begin(index));
        RayInFlight { index, current: self.root, intersector, visitor }
    }

    #[inline(always)]
    fn begin_anew(&self, index: usize, batch: &B, ended: &mut RayInFlight<L, B::Visitor>) {
        *ended = self.begin(index, batch);
    }
}

impl<'a, L: ChildIntersector, B: Batch<'a>> InFlight<B> for RayInFlight<L, B::Visitor> {
    #[inline(always)]
    fn step(&mut self, tree: &Tree, prefetcher: &Prefetcher, stack: &mut Stack) -> bool {
        let Self { current, intersector, visitor, .. } = self;
        if let Content::Node(index) = current.open() {
            let node = &tree.nodes[index];
            intersector.open(node, &node.children, visitor.limit(), B::Visitor::IN_ORDER, stack);
        } else if visit(tree, *current, intersector, visitor).is_break() {
            return false;
        }
        let Some(next) = stack.pop(visitor.limit()) else { return false };
        *current = next;
        prefetcher.ask(next);
        true
    }

    #[inline(always)]
    fn end(&self, batch: &mut B) {
        batch.end(self.index, &self.visitor);
    }
}
