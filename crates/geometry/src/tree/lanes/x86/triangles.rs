//! Four triangles in one register.

use crate::Ray;
use crate::tree::block::Block;
use crate::tree::lanes::Passed;
use crate::tree::node::LEAF;
use crate::watertight::Shear;
use std::arch::x86_64::*;

/// Four triangles at once. Exists only where SSE4.1 does.
pub(super) struct TriangleRay {
    /// Where among the coordinates of a corner, in bytes, those are that stay, and
    /// that of depth.
    axes: [usize; 3],
    /// In the same order.
    origin: [__m128; 3],
    slope: [__m128; 2],
    reciprocal: __m128,
}

impl TriangleRay {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(super) unsafe fn new(ray: &Ray) -> Self {
        let shear = Shear::along(&ray.direction);
        // SAFETY: the caller promises SSE4.1.
        let splat = |x: f32| unsafe { _mm_set1_ps(x) };
        let origin: &[f32; 3] = ray.origin.as_ref();
        Self {
            axes: shear.axes.map(|axis| axis * 16),
            origin: shear.axes.map(|axis| splat(origin[axis])),
            slope: shear.slope.map(splat),
            reciprocal: splat(shear.reciprocal),
        }
    }

    /// [`Shear::flat`], [`is_inside`](crate::watertight::is_inside) and
    /// [`Flat::reaches`](crate::watertight::Flat) for the triangles of a block.
    #[inline(always)]
    pub(super) fn pass(&self, block: &Block, limit: f32) -> Passed {
        // SAFETY: `self` shows that the machine has SSE4.1; a block is aligned to 32
        // bytes, and each of its corners has three rows of 16, at whose starts the
        // offsets are.
        unsafe {
            let zero = _mm_setzero_ps();
            let rows = block.corners.as_ptr();
            let corner = |number: usize| {
                let coordinate = |i: usize| {
                    let row = rows.add(number).byte_add(self.axes[i]).cast::<__m128>();
                    _mm_sub_ps(*row, self.origin[i])
                };
                let (x, y, depth) = (coordinate(0), coordinate(1), coordinate(2));
                let x = _mm_sub_ps(x, _mm_mul_ps(self.slope[0], depth));
                let y = _mm_sub_ps(y, _mm_mul_ps(self.slope[1], depth));
                [x, y, _mm_mul_ps(depth, self.reciprocal)]
            };
            let cross = |[px, py, _]: [__m128; 3], [qx, qy, _]: [__m128; 3]| {
                _mm_sub_ps(_mm_mul_ps(px, qy), _mm_mul_ps(py, qx))
            };
            let [a, b, c] = [corner(0), corner(1), corner(2)];
            let of_a = cross(b, c);
            let of_b = cross(c, a);
            let of_c = cross(a, b);
            let least = |[a, b, c]: [__m128; 3]| _mm_min_ps(_mm_min_ps(a, b), c);
            let greatest = |[a, b, c]: [__m128; 3]| _mm_max_ps(_mm_max_ps(a, b), c);
            let edges = [of_a, of_b, of_c];
            let depths = [a[2], b[2], c[2]];
            let inside =
                _mm_or_ps(_mm_cmpge_ps(least(edges), zero), _mm_cmple_ps(greatest(edges), zero));
            let reached = _mm_and_ps(
                _mm_cmpgt_ps(greatest(depths), zero),
                _mm_cmplt_ps(least(depths), _mm_set1_ps(limit)),
            );
            let mask = _mm_movemask_ps(_mm_and_ps(inside, reached)) as u32;
            let lanes = |row: __m128| {
                let mut lanes = [0.0; LEAF];
                _mm_storeu_ps(lanes.as_mut_ptr(), row);
                lanes
            };
            Passed { mask, edges: edges.map(lanes), depths: depths.map(lanes) }
        }
    }
}
