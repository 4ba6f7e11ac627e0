//! The way of a ray through a tree.

use super::Tree;
use super::lanes::{Lanes, Triangles};
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::{Room, Stack};
use super::visitor::Visitor;
use std::ops::ControlFlow;

/// Takes a ray to all leaves it meets until the visitor breaks.
#[inline(always)]
pub(crate) fn walk<L: Lanes, V: Visitor>(tree: &Tree, root: Child, lanes: &L, visitor: &mut V) {
    let mut room = Room::new();
    let mut stack = Stack::new(&mut room);
    let ahead = Ahead::of(tree);
    let mut next = Some(root);
    while let Some(current) = next {
        next = if let Content::Node(index) = current.open() {
            lanes.open_next(&tree.nodes[index], visitor.limit(), V::IN_ORDER, &mut stack)
        } else if visit(tree, current, lanes, visitor).is_break() {
            None
        } else {
            stack.pop(visitor.limit())
        };
        if tree.is_large()
            && let Some(after_next) = stack.top()
        {
            ahead.ask(after_next);
        }
    }
}

/// Takes the visitor to a leaf.
#[inline(always)]
pub(super) fn visit<T: Triangles, V: Visitor>(
    tree: &Tree,
    leaf: Child,
    lanes: &T,
    visitor: &mut V,
) -> ControlFlow<()> {
    match leaf.open() {
        Content::Node(_) => ControlFlow::Continue(()),
        Content::Block(index) => visitor.triangles(&tree.blocks[index], lanes),
        Content::Shapes(places) => visitor.shapes(places),
    }
}
