//! The way of a ray through a tree.

use super::Tree;
use super::block::Block;
use super::lanes::Lanes;
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::{Room, Stack};
use std::ops::{ControlFlow, Range};

/// What a ray does in the leaves it comes to.
pub(crate) trait Visitor {
    /// Boxes that begin beyond it are left out.
    fn limit(&self) -> f32;

    /// A block of triangles.
    fn triangles<L: Lanes>(&mut self, block: &Block, lanes: &L) -> ControlFlow<()>;

    /// A run of other shapes, as places in the order of the leaves.
    fn shapes(&mut self, places: Range<usize>) -> ControlFlow<()>;
}

/// Takes a ray to all leaves it meets, the nearer boxes of a node first, until the
/// visitor breaks.
#[inline(always)]
pub(crate) fn walk<L: Lanes, V: Visitor>(tree: &Tree, root: Child, lanes: &L, visitor: &mut V) {
    let mut room = Room::new();
    let mut stack = Stack::new(&mut room);
    let ahead = Ahead::of(tree);
    let mut next = Some(root);
    while let Some(current) = next {
        next = if let Content::Node(index) = current.open() {
            lanes.open_next(&tree.nodes[index], visitor.limit(), &mut stack)
        } else if visit(tree, current, lanes, visitor, &mut stack).is_break() {
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

/// Opens a box: the boxes in it go on the stack, shapes to the visitor.
#[inline(always)]
pub(super) fn visit<L: Lanes, V: Visitor>(
    tree: &Tree,
    child: Child,
    lanes: &L,
    visitor: &mut V,
    stack: &mut Stack,
) -> ControlFlow<()> {
    match child.open() {
        Content::Node(index) => lanes.open(&tree.nodes[index], visitor.limit(), stack),
        Content::Block(index) => visitor.triangles(&tree.blocks[index], lanes)?,
        Content::Shapes(places) => visitor.shapes(places)?,
    }
    ControlFlow::Continue(())
}
