//! Four triangles in one register.

use crate::Ray;
use crate::f32_filter::Shear;
use crate::tree::block::Block;
use crate::tree::extents::{CLASS_SHIFT, ERROR_BY_DEPTH, ERROR_BY_SIZE, QuantisedExtents};
use crate::tree::intersector::{
    FARTHER, FilteredTriangles, Hits, TriangleIntersector, meet_in_turn,
};
use crate::tree::node::LEAF;
use std::arch::x86_64::*;

/// Four triangles at once. Exists only where SSE4.1 does and, if `FUSED`, FMA.
#[derive(Clone, Copy)]
pub(crate) struct TriangleRay<const FUSED: bool> {
    /// The offsets, in bytes, among the coordinates of a corner: of those that stay, and of depth.
    pub(super) axes: [usize; 3],
    /// In the same order.
    pub(super) origin: [__m128; 3],
    slope: [__m128; 2],
    reciprocal: __m128,
    /// The direction, the longest coordinate last.
    pub(super) direction: [__m128; 3],
    /// From t to how far corners may be off by rounding, with room.
    error_bound: __m128,
    /// The bits of the size of the largest triangles of the tree.
    greatest: __m128i,
}

/// Four triangles as a ray sees them: [`Shear::apply`] of each.
struct Seen {
    edges: [__m128; 3],
    depths: [__m128; 3],
}

impl<const FUSED: bool> TriangleRay<FUSED> {
    /// # Safety
    /// The machine must have SSE4.1, and FMA if `FUSED`.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Ray, extents: QuantisedExtents) -> Self {
        let shear = Shear::along(&ray.direction);
        // SAFETY: the caller promises SSE4.1.
        let splat = |x: f32| unsafe { _mm_set1_ps(x) };
        let origin: &[f32; 3] = ray.origin.as_ref();
        let direction: &[f32; 3] = ray.direction.as_ref();
        Self {
            axes: shear.axes.map(|axis| axis * 16),
            origin: shear.axes.map(|axis| splat(origin[axis])),
            slope: shear.slope.map(splat),
            reciprocal: splat(shear.reciprocal),
            direction: shear.axes.map(|axis| splat(direction[axis])),
            error_bound: splat(ERROR_BY_DEPTH * direction[shear.axes[2]].abs()),
            // SAFETY: as above.
            greatest: unsafe { _mm_set1_epi32(extents.greatest.cast_signed()) },
        }
    }

    /// With sums of products of either kind.
    #[inline(always)]
    fn see(&self, block: &Block, minus_product: impl Fn(__m128, [__m128; 2]) -> __m128) -> Seen {
        // SAFETY: `self` shows that the machine has SSE4.1; a block is aligned to 32
        // bytes, and each of its corners has three rows of 16, at whose starts the
        // offsets are.
        unsafe {
            let rows = block.corners.as_ptr();
            let corner = |number: usize| {
                let coordinate = |i: usize| {
                    let row = rows.add(number).byte_add(self.axes[i]).cast::<__m128>();
                    _mm_sub_ps(*row, self.origin[i])
                };
                let (x, y, depth) = (coordinate(0), coordinate(1), coordinate(2));
                let x = minus_product(x, [self.slope[0], depth]);
                let y = minus_product(y, [self.slope[1], depth]);
                [x, y, _mm_mul_ps(depth, self.reciprocal)]
            };
            let cross = |[px, py, _]: [__m128; 3], [qx, qy, _]: [__m128; 3]| {
                minus_product(_mm_mul_ps(px, qy), [py, qx])
            };
            let [a, b, c] = [corner(0), corner(1), corner(2)];
            Seen { edges: [cross(b, c), cross(c, a), cross(a, b)], depths: [a[2], b[2], c[2]] }
        }
    }
}

impl<const FUSED: bool> TriangleIntersector for TriangleRay<FUSED> {
    #[inline(always)]
    fn meet(&self, block: &Block, candidates: u32, ray: &Ray, limit: f32) -> Hits<LEAF> {
        if FUSED {
            self.meet_at_once(block, candidates, ray, limit)
        } else {
            meet_in_turn(block, candidates, ray, limit)
        }
    }

    /// The triangles of which the edge functions, with all error, can have one sign.
    ///
    /// With u the rounding of one operation, L the extent of a triangle along the axes and D
    /// its depth, corners are off by 5 u D + 9 u L at most, and corners of a triangle that the
    /// ray meets are at most 2 L from it in the plane: so edge functions are off by less than
    /// 48 u (L + 48 u D) (D + 2 L).
    #[inline(always)]
    fn candidates(&self, block: &Block, limit: f32) -> u32 {
        // SAFETY: `self` shows that the machine has SSE4.1, and FMA if `FUSED`; words are
        // 16 bytes, and those before them are whole rows of 16, aligned to 32.
        unsafe {
            let Seen { edges, depths } = self.see(block, |a, [b, c]| {
                if FUSED { _mm_fnmadd_ps(b, c, a) } else { rounded_twice(a, [b, c]) }
            });
            let farthest = greatest(depths);
            let words = _mm_load_si128(block.words.as_ptr().cast());
            let class = _mm_srli_epi32::<{ CLASS_SHIFT }>(words);
            let steps = _mm_slli_epi32::<{ QuantisedExtents::CLASS_IN_FLOAT }>(class);
            let size = _mm_castsi128_ps(_mm_sub_epi32(self.greatest, steps));
            let by_depth = _mm_mul_ps(farthest, self.error_bound);
            let by_size = _mm_mul_ps(size, _mm_set1_ps(ERROR_BY_SIZE));
            let error_bound = _mm_mul_ps(_mm_add_ps(size, by_depth), _mm_add_ps(by_size, by_depth));
            // Products may vanish that are not zero; what is not a number is not decided.
            let nothing = _mm_set1_ps(-f32::MIN_POSITIVE);
            let inside = _mm_or_ps(
                _mm_cmpnlt_ps(_mm_add_ps(least(edges), error_bound), nothing),
                _mm_cmpnlt_ps(_mm_sub_ps(error_bound, greatest(edges)), nothing),
            );
            let limit = _mm_set1_ps(limit * FARTHER);
            let reached = _mm_and_ps(
                _mm_cmpgt_ps(farthest, _mm_setzero_ps()),
                _mm_cmplt_ps(least(depths), limit),
            );
            _mm_movemask_ps(_mm_and_ps(inside, reached)) as u32
        }
    }

    /// [`ShearedTriangle::may_meet`](crate::f32_filter::ShearedTriangle::may_meet) for the
    /// triangles of a block.
    #[inline(always)]
    fn filter(&self, block: &Block, limit: f32) -> FilteredTriangles {
        // SAFETY: `self` shows that the machine has SSE4.1.
        unsafe {
            let Seen { edges, depths } = self.see(block, rounded_twice);
            let zero = _mm_setzero_ps();
            let inside =
                _mm_or_ps(_mm_cmpge_ps(least(edges), zero), _mm_cmple_ps(greatest(edges), zero));
            let reached = _mm_and_ps(
                _mm_cmpgt_ps(greatest(depths), zero),
                _mm_cmplt_ps(least(depths), _mm_set1_ps(limit)),
            );
            let mask = _mm_movemask_ps(_mm_and_ps(inside, reached)) as u32;
            let to_array = |row: __m128| {
                let mut array = [0.0; LEAF];
                _mm_storeu_ps(array.as_mut_ptr(), row);
                array
            };
            FilteredTriangles { mask, edges: edges.map(to_array), depths: depths.map(to_array) }
        }
    }
}

/// a − b c as [`Shear::apply`] has it.
#[inline(always)]
fn rounded_twice(a: __m128, [b, c]: [__m128; 2]) -> __m128 {
    // SAFETY: every x86-64 machine has SSE.
    unsafe { _mm_sub_ps(a, _mm_mul_ps(b, c)) }
}

#[inline(always)]
fn least([a, b, c]: [__m128; 3]) -> __m128 {
    // SAFETY: every x86-64 machine has SSE.
    unsafe { _mm_min_ps(_mm_min_ps(a, b), c) }
}

#[inline(always)]
fn greatest([a, b, c]: [__m128; 3]) -> __m128 {
    // SAFETY: every x86-64 machine has SSE.
    unsafe { _mm_max_ps(_mm_max_ps(a, b), c) }
}
