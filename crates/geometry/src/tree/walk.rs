//! The way of a ray through a tree.

use super::block::Block;
use super::lanes::{Lanes, Passed};
use super::node::{Child, Content, Node, WIDTH};
use super::stack::Stack;
use std::ops::ControlFlow;

/// What a ray does in the leaves it comes to.
pub(crate) trait Visitor {
    /// Boxes that begin beyond it are left out.
    fn limit(&self) -> f32;

    /// A block of which the ray passes some triangles.
    fn triangles(&mut self, block: &Block, passed: &Passed) -> ControlFlow<()>;

    /// A run of other shapes, as places in the order of the leaves.
    fn shapes(&mut self, places: std::ops::Range<usize>) -> ControlFlow<()>;
}

/// Takes a ray to all leaves it meets, the nearer boxes of a node first, until the
/// visitor breaks.
#[inline(always)]
pub(crate) fn walk<L: Lanes, V: Visitor>(
    lanes: &L,
    root: Child,
    nodes: &[Node],
    blocks: &[Block],
    visitor: &mut V,
) {
    let mut stack = Stack::new();
    let mut current = root;
    loop {
        match current.open() {
            Content::Node(index) => {
                let node = &nodes[index];
                let (enter, mask) = lanes.enter(node, visitor.limit());
                if let Some(next) = nearest(&mut stack, node, &enter, mask) {
                    current = next;
                    continue;
                }
            }
            Content::Block(index) => {
                let block = &blocks[index];
                let passed = lanes.pass(block, visitor.limit());
                if passed.mask != 0 && visitor.triangles(block, &passed).is_break() {
                    return;
                }
            }
            Content::Shapes(places) => {
                if visitor.shapes(places).is_break() {
                    return;
                }
            }
        }
        let Some(next) = stack.pop(visitor.limit()) else { return };
        current = next;
    }
}

/// The box to open next; the others that were met wait, the nearest on top.
#[inline(always)]
fn nearest(
    stack: &mut Stack,
    node: &Node,
    enter: &[f32; WIDTH],
    mut mask: u32,
) -> Option<Child> {
    let mut next: Option<(f32, Child)> = None;
    let bottom = stack.len();
    while mask != 0 {
        let lane = mask.trailing_zeros() as usize % WIDTH;
        mask &= mask - 1;
        let mut met = (enter[lane], node.children[lane]);
        if let Some(next) = &mut next {
            if met.0 < next.0 {
                std::mem::swap(&mut met, next);
            }
            stack.insert(bottom, met);
        } else {
            next = Some(met);
        }
    }
    next.map(|(_, child)| child)
}
