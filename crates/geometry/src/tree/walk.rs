//! The way of a ray through a tree.

use super::block::Block;
use super::lanes::{Lanes, Passed};
use super::node::{Child, Content, Node};
use super::prepared::Prepared;
use super::stack::{Room, Stack};
use std::ops::ControlFlow;

/// What a ray does in the leaves it comes to.
pub(crate) trait Visitor {
    /// Boxes that begin beyond it are left out.
    fn limit(&self) -> f32;

    /// A block of which the ray passes some triangles.
    fn triangles(&mut self, ray: &Prepared, block: &Block, passed: &Passed) -> ControlFlow<()>;

    /// A run of other shapes, as places in the order of the leaves.
    fn shapes(&mut self, places: std::ops::Range<usize>) -> ControlFlow<()>;
}

/// Takes a ray to all leaves it meets, the nearer boxes of a node first, until the
/// visitor breaks.
#[inline(always)]
pub(crate) fn walk<L: Lanes, V: Visitor>(
    lanes: &L,
    ray: &Prepared,
    root: Child,
    nodes: &[Node],
    blocks: &[Block],
    visitor: &mut V,
) {
    let mut room = Room::new();
    let mut stack = Stack::new(&mut room);
    let mut current = root;
    loop {
        match current.open() {
            Content::Node(index) => {
                lanes.open(&nodes[index], visitor.limit(), &mut stack);
            }
            Content::Block(index) => {
                let block = &blocks[index];
                let passed = lanes.pass(block);
                if passed.mask != 0 && visitor.triangles(ray, block, &passed).is_break() {
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
