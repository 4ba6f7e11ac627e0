//! The way of a ray through a tree.

use super::Tree;
use super::block::Block;
use super::eights::Eights;
use super::fan::{Sight, Visitors};
use super::lanes::{Lanes, Triangles};
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::{Room, Stack};
use std::ops::{ControlFlow, Range};

/// What a ray does in the leaves it comes to.
pub(crate) trait Visitor: Sized {
    /// Whether the nearer boxes are better opened first. Where any hit will do they are not:
    /// most rays start on a surface, and what is in the boxes around it they just left.
    const IN_ORDER: bool;

    /// Boxes that begin beyond it are left out: all, once it has broken.
    fn limit(&self) -> f32;

    /// A block of triangles.
    fn triangles<T: Triangles>(&mut self, block: &Block, lanes: &T) -> ControlFlow<()>;

    /// A block of triangles, for those rays of a fan that have a bit.
    fn fan<E: Eights>(rays: &mut Visitors<Self>, active: u32, block: &Block, sight: &Sight<E>);

    /// A run of other shapes, as places in the order of the leaves.
    fn shapes(&mut self, places: Range<usize>) -> ControlFlow<()>;
}

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

/// The places of the ones in a mask, the lowest first.
#[inline(always)]
pub(crate) fn ones(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize)?;
        mask &= mask - 1;
        Some(place)
    })
}
