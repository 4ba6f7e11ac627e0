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
        let mut entries = [0.0; WIDTH];
        let mut mask = 0;
        for (lane, entry) in entries.iter_mut().enumerate() {
            let plane = |row: usize, axis: usize| node.planes[row][lane] - ray.origin[axis];
            let near = |axis: usize| plane(ray.near_row[axis], axis) * ray.near[axis];
            let far = |axis: usize| plane(ray.near_row[axis] ^ 1, axis) * ray.far[axis];
            *entry = greater(greater(near(0), near(1)), greater(near(2), 0.0));
            let leave = lesser(lesser(far(0), far(1)), lesser(far(2), limit));
            mask |= u32::from(*entry <= leave) << lane;
        }
        push(node, ray.octant, &entries, mask, stack);
    }

    #[inline]
    fn pass(&self, block: &Block, limit: f32) -> Passed {
        let none = [[0.0; LEAF]; 3];
        let mut passed = Passed { mask: 0, edges: none, depths: none };
        for lane in 0..LEAF {
            let flat = self.shear.flat(&block.triangle(lane), &self.ray.origin);
            let is_passed = is_inside(flat.edges) && flat.reaches(limit);
            passed.mask |= u32::from(is_passed) << lane;
            for corner in 0..3 {
                passed.edges[corner][lane] = flat.edges[corner];
                passed.depths[corner][lane] = flat.depths[corner];
            }
        }
        passed
    }
}

/// What is not a number loses; of two, the second stays.
#[inline]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

#[inline]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
