//! The kernel for any machine, which is what the others are checked against.

use super::{Lanes, Passed, push};
use crate::tree::block::Block;
use crate::tree::node::{LEAF, Node, WIDTH};
use crate::tree::prepared::Prepared;
use crate::tree::stack::Stack;
use crate::watertight::is_inside;

impl Lanes for Prepared<'_> {
    #[inline]
    fn open(&self, node: &Node, limit: f32, stack: &mut Stack) {
        let ray = &self.boxes;
        let mut enter = [0.0; WIDTH];
        let mut mask = 0;
        for lane in 0..WIDTH {
            let mut leave = limit;
            for axis in 0..3 {
                let row = ray.near_row[axis];
                let near = (node.planes[row][lane] - ray.origin[axis]) * ray.near[axis];
                let far = (node.planes[row ^ 1][lane] - ray.origin[axis]) * ray.far[axis];
                enter[lane] = if near > enter[lane] { near } else { enter[lane] };
                leave = if far < leave { far } else { leave };
            }
            mask |= u32::from(enter[lane] <= leave) << lane;
        }
        push(node, ray.octant, &enter, mask, stack);
    }

    #[inline]
    fn pass(&self, block: &Block) -> Passed {
        let mut passed = Passed { mask: 0, edges: [[0.0; LEAF]; 3] };
        for lane in 0..LEAF {
            let edges = self.shear.edges(block.triangle(lane), self.ray.origin);
            passed.mask |= u32::from(is_inside(edges)) << lane;
            for (row, edge) in passed.edges.iter_mut().zip(edges) {
                row[lane] = edge;
            }
        }
        passed
    }
}
