//! Eight boxes in two registers.

use super::boxes::{PLANES, RayBoxes};
use crate::Ray;
use crate::tree::block::Block;
use crate::tree::intersector::{ChildIntersector, FilteredTriangles, TriangleIntersector, push};
use crate::tree::node::{Child, Node, WIDTH};
use crate::tree::simd::Sse41Simd;
use crate::tree::stack::Stack;
use std::arch::x86_64::*;

/// Four boxes at once, twice.
#[derive(Clone, Copy)]
pub(crate) struct Sse41<T> {
    origin: [__m128; 3],
    near: [__m128; 3],
    far: [__m128; 3],
    octant: i32,
    triangles: T,
}

impl<T: Copy> Sse41<T> {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Ray, triangles: T) -> Self {
        // SAFETY: the caller promises SSE4.1.
        unsafe {
            let boxes = RayBoxes::of(ray);
            Self {
                origin: ray.origin.to_array().map(|x| _mm_set1_ps(x)),
                near: boxes.near(),
                far: boxes.far(),
                octant: boxes.octant,
                triangles,
            }
        }
    }

    /// The first four boxes of a node, or, for `half` 1, the others.
    #[inline(always)]
    fn enter_half(&self, node: &Node, limit: f32, half: usize) -> (__m128, u32) {
        // SAFETY: `self` shows that the machine has SSE4.1; a node is aligned to 64
        // bytes and has six rows of 32, at whose starts the offsets are.
        unsafe {
            let rows = node.planes.as_ptr().cast::<__m128>().add(half);
            let planes = &PLANES[self.octant as usize % 8];
            let from_origin =
                |offset: usize, axis: usize| _mm_sub_ps(*rows.byte_add(offset), self.origin[axis]);
            let near = |axis: usize| _mm_mul_ps(from_origin(planes[axis], axis), self.near[axis]);
            let far = |axis: usize| _mm_mul_ps(from_origin(planes[axis + 3], axis), self.far[axis]);
            // What is not a number leaves the second operand.
            let enter =
                _mm_max_ps(_mm_max_ps(near(0), near(1)), _mm_max_ps(near(2), _mm_setzero_ps()));
            let leave =
                _mm_min_ps(_mm_min_ps(far(0), far(1)), _mm_min_ps(far(2), _mm_set1_ps(limit)));
            (enter, _mm_movemask_ps(_mm_cmple_ps(enter, leave)) as u32)
        }
    }
}

impl<T: TriangleIntersector> ChildIntersector for Sse41<T> {
    type Simd = Sse41Simd;

    #[inline(always)]
    fn simd(&self) -> Sse41Simd {
        Sse41Simd
    }

    #[inline(always)]
    fn open(
        &self,
        node: &Node,
        names: &[Child; WIDTH],
        limit: f32,
        _in_order: bool,
        stack: &mut Stack,
    ) {
        let (low, low_mask) = self.enter_half(node, limit, 0);
        let (high, high_mask) = self.enter_half(node, limit, 1);
        let mut entries = [0.0; WIDTH];
        // SAFETY: `self` shows that the machine has SSE4.1; both halves have room
        // for four numbers.
        unsafe {
            _mm_storeu_ps(entries[..4].as_mut_ptr(), low);
            _mm_storeu_ps(entries[4..].as_mut_ptr(), high);
        }
        push(node, names, self.octant, &entries, low_mask | high_mask << 4, stack);
    }

    #[inline(always)]
    fn with_reciprocals(self, near: [f32; 3], far: [f32; 3]) -> Self {
        // SAFETY: `self` shows that the machine has SSE4.1.
        let splat = |x: f32| unsafe { _mm_set1_ps(x) };
        Self { near: near.map(splat), far: far.map(splat), ..self }
    }
}

impl<T: TriangleIntersector> TriangleIntersector for Sse41<T> {
    #[inline(always)]
    fn candidates(&self, block: &Block, limit: f32) -> u32 {
        self.triangles.candidates(block, limit)
    }

    #[inline(always)]
    fn filter(&self, block: &Block, limit: f32) -> FilteredTriangles {
        self.triangles.filter(block, limit)
    }
}
