//! The way of a ray through a tree.

use super::Tree;
use super::intersector::{ChildIntersector, TriangleIntersector};
use super::node::{Child, Content};
use super::prefetch::Prefetcher;
use super::stack::{Room, Stack};
use super::visitor::Visitor;
use std::ops::ControlFlow;

/// Takes a ray to all leaves it meets until the visitor breaks.
#[inline(always)]
pub(crate) fn walk<L: ChildIntersector, V: Visitor>(
    tree: &Tree,
    root: Child,
    intersector: &L,
    visitor: &mut V,
) {
    let mut room = Room::new();
    let mut stack = Stack::new(&mut room);
    let prefetcher = Prefetcher::of(tree);
    let mut next = Some(root);
    while let Some(current) = next {
        next = if let Content::Node(index) = current.open() {
            intersector.open_next(&tree.nodes[index], visitor.limit(), V::IN_ORDER, &mut stack)
        } else if visit(tree, current, intersector, visitor).is_break() {
            None
        } else {
            stack.pop(visitor.limit())
        };
        if tree.is_large()
            && let Some(after_next) = stack.top()
        {
            prefetcher.ask(after_next);
        }
    }
}

/// Takes the visitor to a leaf.
#[inline(always)]
pub(super) fn visit<T: TriangleIntersector, V: Visitor>(
    tree: &Tree,
    leaf: Child,
    intersector: &T,
    visitor: &mut V,
) -> ControlFlow<()> {
    match leaf.open() {
        Content::Node(_) => ControlFlow::Continue(()),
        Content::Block(index) => visitor.triangles(&tree.blocks[index], intersector),
        Content::Shapes(places) => visitor.shapes(places),
    }
}
