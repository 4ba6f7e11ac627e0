//! The kernels for x86-64: AVX2, and SSE4.1 for older machines.
//!
//! Each type exists only where its instructions do: that is the promise of its
//! `new`, and what makes its methods sound. They are inlined into a function that
//! is compiled for those instructions.

#![allow(unsafe_code)]

use super::{Lanes, Passed};
use crate::Ray;
use crate::tree::block::Block;
use crate::tree::boxes::BoxRay;
use crate::tree::node::{LEAF, Node, WIDTH};
use crate::watertight::Shear;
use std::arch::x86_64::*;

/// Eight boxes at once.
pub(crate) struct Avx2 {
    origin: [__m256; 3],
    near: [__m256; 3],
    far: [__m256; 3],
    near_row: [usize; 3],
    triangles: TriangleRay,
}

impl Avx2 {
    /// # Safety
    /// The machine must have AVX2.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Ray) -> Self {
        let boxes = BoxRay::new(ray);
        // SAFETY: the caller promises AVX2.
        let splat = |values: [f32; 3]| values.map(|x| unsafe { _mm256_set1_ps(x) });
        Self {
            origin: splat(boxes.origin),
            near: splat(boxes.near),
            far: splat(boxes.far),
            near_row: boxes.near_row,
            // SAFETY: AVX2 includes SSE4.1.
            triangles: unsafe { TriangleRay::new(ray) },
        }
    }
}

impl Lanes for Avx2 {
    #[inline(always)]
    fn enter(&self, node: &Node, limit: f32) -> ([f32; WIDTH], u32) {
        // SAFETY: `self` shows that the machine has AVX2; rows are 32 bytes long
        // and, in a node, lie at multiples of 32.
        unsafe {
            let distance = |row: usize, axis: usize| {
                let plane = _mm256_load_ps(node.planes[row].as_ptr());
                _mm256_sub_ps(plane, self.origin[axis])
            };
            let mut enter = _mm256_setzero_ps();
            let mut leave = _mm256_set1_ps(limit);
            for axis in 0..3 {
                let row = self.near_row[axis];
                // What is not a number leaves the second operand.
                enter = _mm256_max_ps(_mm256_mul_ps(distance(row, axis), self.near[axis]), enter);
                leave = _mm256_min_ps(_mm256_mul_ps(distance(row ^ 1, axis), self.far[axis]), leave);
            }
            let mask = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave));
            let mut entries = [0.0; WIDTH];
            _mm256_storeu_ps(entries.as_mut_ptr(), enter);
            (entries, mask as u32)
        }
    }

    #[inline(always)]
    fn pass(&self, block: &Block, limit: f32) -> Passed {
        self.triangles.pass(block, limit)
    }
}

/// Four boxes at once, twice.
pub(crate) struct Sse41 {
    origin: [__m128; 3],
    near: [__m128; 3],
    far: [__m128; 3],
    near_row: [usize; 3],
    triangles: TriangleRay,
}

impl Sse41 {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Ray) -> Self {
        let boxes = BoxRay::new(ray);
        // SAFETY: the caller promises SSE4.1.
        let splat = |values: [f32; 3]| values.map(|x| unsafe { _mm_set1_ps(x) });
        Self {
            origin: splat(boxes.origin),
            near: splat(boxes.near),
            far: splat(boxes.far),
            near_row: boxes.near_row,
            // SAFETY: the same promise.
            triangles: unsafe { TriangleRay::new(ray) },
        }
    }

    /// Boxes `first` to `first + 3` of a node; `first` is 0 or 4.
    #[inline(always)]
    fn enter_half(&self, node: &Node, limit: f32, first: usize) -> (__m128, u32) {
        // SAFETY: `self` shows that the machine has SSE4.1; half a row is 16 bytes
        // long and, in a node, lies at a multiple of 16.
        unsafe {
            let distance = |row: usize, axis: usize| {
                let plane = _mm_load_ps(node.planes[row][first..][..4].as_ptr());
                _mm_sub_ps(plane, self.origin[axis])
            };
            let mut enter = _mm_setzero_ps();
            let mut leave = _mm_set1_ps(limit);
            for axis in 0..3 {
                let row = self.near_row[axis];
                // What is not a number leaves the second operand.
                enter = _mm_max_ps(_mm_mul_ps(distance(row, axis), self.near[axis]), enter);
                leave = _mm_min_ps(_mm_mul_ps(distance(row ^ 1, axis), self.far[axis]), leave);
            }
            (enter, _mm_movemask_ps(_mm_cmple_ps(enter, leave)) as u32)
        }
    }
}

impl Lanes for Sse41 {
    #[inline(always)]
    fn enter(&self, node: &Node, limit: f32) -> ([f32; WIDTH], u32) {
        let (low, low_mask) = self.enter_half(node, limit, 0);
        let (high, high_mask) = self.enter_half(node, limit, 4);
        let mut entries = [0.0; WIDTH];
        // SAFETY: `self` shows that the machine has SSE4.1; both halves have room
        // for four numbers.
        unsafe {
            _mm_storeu_ps(entries[..4].as_mut_ptr(), low);
            _mm_storeu_ps(entries[4..].as_mut_ptr(), high);
        }
        (entries, low_mask | high_mask << 4)
    }

    #[inline(always)]
    fn pass(&self, block: &Block, limit: f32) -> Passed {
        self.triangles.pass(block, limit)
    }
}

/// Four triangles at once. Exists only where SSE4.1 does.
struct TriangleRay {
    axes: [usize; 3],
    /// In the order of `axes`.
    origin: [__m128; 3],
    slope: [__m128; 2],
    reciprocal: __m128,
}

impl TriangleRay {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    unsafe fn new(ray: &Ray) -> Self {
        let shear = Shear::along(ray.direction);
        // SAFETY: the caller promises SSE4.1.
        let splat = |x: f32| unsafe { _mm_set1_ps(x) };
        Self {
            axes: shear.axes,
            origin: shear.axes.map(|axis| splat(ray.origin[axis])),
            slope: shear.slope.map(splat),
            reciprocal: splat(shear.reciprocal),
        }
    }

    /// [`Shear::flatten`] and [`Flat::is_inside`](crate::watertight::Flat) for the
    /// triangles of a block.
    #[inline(always)]
    fn pass(&self, block: &Block, limit: f32) -> Passed {
        // SAFETY: `self` shows that the machine has SSE4.1; rows are 16 bytes long
        // and, in a block, lie at multiples of 16.
        unsafe {
            let zero = _mm_setzero_ps();
            let corner = |rows: &[[f32; LEAF]; 3]| {
                let [x, y, depth] = std::array::from_fn(|i| {
                    let row = _mm_load_ps(rows[self.axes[i]].as_ptr());
                    _mm_sub_ps(row, self.origin[i])
                });
                let x = _mm_sub_ps(x, _mm_mul_ps(self.slope[0], depth));
                let y = _mm_sub_ps(y, _mm_mul_ps(self.slope[1], depth));
                (x, y, _mm_mul_ps(depth, self.reciprocal))
            };
            let cross = |(px, py): (__m128, __m128), (qx, qy): (__m128, __m128)| {
                _mm_sub_ps(_mm_mul_ps(px, qy), _mm_mul_ps(py, qx))
            };
            let [a, b, c] = [0, 1, 2].map(|i| corner(&block.corners[i]));
            let of_a = cross((b.0, b.1), (c.0, c.1));
            let of_b = cross((c.0, c.1), (a.0, a.1));
            let of_c = cross((a.0, a.1), (b.0, b.1));
            let least = _mm_min_ps(_mm_min_ps(of_a, of_b), of_c);
            let most = _mm_max_ps(_mm_max_ps(of_a, of_b), of_c);
            let inside = _mm_or_ps(_mm_cmpge_ps(least, zero), _mm_cmple_ps(most, zero));
            let first = _mm_min_ps(_mm_min_ps(a.2, b.2), c.2);
            let last = _mm_max_ps(_mm_max_ps(a.2, b.2), c.2);
            let reaches =
                _mm_and_ps(_mm_cmpgt_ps(last, zero), _mm_cmplt_ps(first, _mm_set1_ps(limit)));
            let mask = _mm_movemask_ps(_mm_and_ps(inside, reaches)) as u32;
            let rows = |rows: [__m128; 3]| {
                rows.map(|row| {
                    let mut lanes = [0.0; LEAF];
                    _mm_storeu_ps(lanes.as_mut_ptr(), row);
                    lanes
                })
            };
            Passed {
                mask,
                edges: rows([of_a, of_b, of_c]),
                depths: rows([a.2, b.2, c.2]),
            }
        }
    }
}
