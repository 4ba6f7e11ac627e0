//! The way of a ray through a tree.

use super::Tree;
use super::intersector::ChildIntersector;
use super::node::{Child, Content};
use super::prefetch::Prefetcher;
use super::shape_block::Line;
use super::stack::{Stack, StackMemory};
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
    let mut memory = StackMemory::new();
    let mut stack = Stack::new(&mut memory);
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
pub(super) fn visit<L: ChildIntersector, V: Visitor>(
    tree: &Tree,
    leaf: Child,
    intersector: &L,
    visitor: &mut V,
) -> ControlFlow<()> {
    if V::ONLY_TRIANGLES {
        return visitor.triangles(&tree.triangles[leaf.index()], intersector);
    }
    match leaf.open() {
        Content::Node(_) => ControlFlow::Continue(()),
        Content::Triangles(index) => visitor.triangles(&tree.triangles[index], intersector),
        Content::Quads(index) => {
            let line = Line::of(intersector.simd(), visitor.ray());
            visitor.block(&tree.quads[index], &line)
        }
        Content::Spheres(index) => {
            let line = Line::of(intersector.simd(), visitor.ray());
            visitor.block(&tree.spheres[index], &line)
        }
        Content::Disks(index) => {
            let line = Line::of(intersector.simd(), visitor.ray());
            visitor.block(&tree.disks[index], &line)
        }
        Content::Shapes(places) => visitor.shapes(places),
    }
}
