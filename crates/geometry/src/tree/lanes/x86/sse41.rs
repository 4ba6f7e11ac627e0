//! Eight boxes in two registers.

use super::triangles::TriangleRay;
use crate::tree::block::Block;
use crate::tree::lanes::{Lanes, Passed, push};
use crate::tree::node::{Node, WIDTH};
use crate::tree::prepared::Prepared;
use crate::tree::stack::Stack;
use std::arch::x86_64::*;

/// Four boxes at once, twice.
pub(crate) struct Sse41 {
    origin: [__m128; 3],
    near: [__m128; 3],
    far: [__m128; 3],
    near_row: [usize; 3],
    octant: i32,
    triangles: TriangleRay,
}

impl Sse41 {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Prepared) -> Self {
        let boxes = &ray.boxes;
        // SAFETY: the caller promises SSE4.1.
        let splat = |values: [f32; 3]| values.map(|x| unsafe { _mm_set1_ps(x) });
        Self {
            origin: splat(boxes.origin),
            near: splat(boxes.near),
            far: splat(boxes.far),
            near_row: boxes.near_row,
            octant: boxes.octant,
            // SAFETY: the same promise.
            triangles: unsafe { TriangleRay::new(ray) },
        }
    }

    /// The first four boxes of a node, or, for `half` 1, the others.
    #[inline(always)]
    fn enter_half(&self, node: &Node, limit: f32, half: usize) -> (__m128, u32) {
        // SAFETY: `self` shows that the machine has SSE4.1; a node is aligned to 64
        // bytes and has six rows of twice 16, which `near_row` counts.
        unsafe {
            let rows = node.planes.as_ptr().cast::<__m128>().add(half);
            let plane = |row: usize, axis: usize| _mm_sub_ps(*rows.add(2 * row), self.origin[axis]);
            let near = |axis: usize| _mm_mul_ps(plane(self.near_row[axis], axis), self.near[axis]);
            let far =
                |axis: usize| _mm_mul_ps(plane(self.near_row[axis] ^ 1, axis), self.far[axis]);
            // What is not a number leaves the second operand.
            let enter =
                _mm_max_ps(_mm_max_ps(near(0), near(1)), _mm_max_ps(near(2), _mm_setzero_ps()));
            let leave =
                _mm_min_ps(_mm_min_ps(far(0), far(1)), _mm_min_ps(far(2), _mm_set1_ps(limit)));
            (enter, _mm_movemask_ps(_mm_cmple_ps(enter, leave)) as u32)
        }
    }
}

impl Lanes for Sse41 {
    #[inline(always)]
    fn open(&self, node: &Node, limit: f32, stack: &mut Stack) {
        let (low, low_mask) = self.enter_half(node, limit, 0);
        let (high, high_mask) = self.enter_half(node, limit, 1);
        let mut entries = [0.0; WIDTH];
        // SAFETY: `self` shows that the machine has SSE4.1; both halves have room
        // for four numbers.
        unsafe {
            _mm_storeu_ps(entries[..4].as_mut_ptr(), low);
            _mm_storeu_ps(entries[4..].as_mut_ptr(), high);
        }
        push(node, self.octant, &entries, low_mask | high_mask << 4, stack);
    }

    #[inline(always)]
    fn pass(&self, block: &Block) -> Passed {
        self.triangles.pass(block)
    }
}
