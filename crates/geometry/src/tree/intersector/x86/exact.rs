//! The intersection of a ray with four triangles, in double precision.

use super::triangles::TriangleRay;
use crate::Ray;
use crate::tree::block::Block;
use crate::tree::intersector::{Hits, meet_in_turn};
use crate::tree::node::LEAF;
use std::arch::x86_64::*;

/// Four corners as a ray sees them; see [`watertight`](crate::watertight).
#[derive(Clone, Copy)]
struct Corners {
    x: __m256d,
    y: __m256d,
    depth: __m256d,
}

impl<const FUSED: bool> TriangleRay<FUSED> {
    /// [`watertight::meet`](crate::watertight::meet) for those triangles that have a bit.
    /// Only where `FUSED`.
    #[inline(always)]
    pub(super) fn meet_at_once(
        &self,
        block: &Block,
        candidates: u32,
        ray: &Ray,
        limit: f32,
    ) -> Hits<LEAF> {
        // SAFETY: `FUSED` shows that the machine has AVX2.
        unsafe {
            let zero = _mm256_setzero_pd();
            let [a, b, c] =
                [self.corners(block, 0), self.corners(block, 1), self.corners(block, 2)];
            let edges = [edge(&b, &c), edge(&c, &a), edge(&a, &b)];
            let is_zero = edges.map(|edge| _mm256_cmp_pd::<_CMP_EQ_OQ>(edge, zero));
            let undecided = _mm256_or_pd(_mm256_or_pd(is_zero[0], is_zero[1]), is_zero[2]);
            if _mm256_movemask_pd(undecided) as u32 & candidates != 0 {
                return meet_in_turn_rarely(block, candidates, ray, limit);
            }
            let [of_a, of_b, of_c] = edges;
            let least = _mm256_min_pd(_mm256_min_pd(of_a, of_b), of_c);
            let greatest = _mm256_max_pd(_mm256_max_pd(of_a, of_b), of_c);
            let inside = _mm256_or_pd(
                _mm256_cmp_pd::<_CMP_GT_OQ>(least, zero),
                _mm256_cmp_pd::<_CMP_LT_OQ>(greatest, zero),
            );
            let times = |p: __m256d, q: __m256d| _mm256_mul_pd(p, q);
            let sum = |p: __m256d, q: __m256d| _mm256_add_pd(p, q);
            let longest = _mm256_cvtps_pd(self.direction[2]);
            let whole = times(sum(sum(of_a, of_b), of_c), longest);
            let scale = _mm256_div_pd(_mm256_set1_pd(1.0), whole);
            let depths = sum(times(of_a, a.depth), times(of_b, b.depth));
            let t = _mm256_cvtpd_ps(times(sum(depths, times(of_c, c.depth)), scale));
            let share = times(scale, longest);
            let [u, v] = [of_b, of_c].map(|of| _mm256_cvtpd_ps(times(of, share)));
            let counts =
                _mm_and_ps(_mm_cmpgt_ps(t, _mm_setzero_ps()), _mm_cmplt_ps(t, _mm_set1_ps(limit)));
            let mask = _mm256_movemask_pd(inside) & _mm_movemask_ps(counts);
            let to_array = |row: __m128| {
                let mut array = [0.0; LEAF];
                _mm_storeu_ps(array.as_mut_ptr(), row);
                array
            };
            Hits { mask: mask as u32 & candidates, t: to_array(t), u: to_array(u), v: to_array(v) }
        }
    }

    #[inline(always)]
    fn corners(&self, block: &Block, number: usize) -> Corners {
        // SAFETY: as above; a block is aligned to 32 bytes, and each of its corners has three
        // rows of 16, at whose starts the offsets are.
        unsafe {
            let rows = block.corners.as_ptr().add(number);
            let from_origin = |i: usize| {
                let row = _mm256_cvtps_pd(*rows.byte_add(self.axes[i]).cast::<__m128>());
                _mm256_sub_pd(row, _mm256_cvtps_pd(self.origin[i]))
            };
            let direction = |i: usize| _mm256_cvtps_pd(self.direction[i]);
            let depth = from_origin(2);
            let moved = |i: usize| {
                let along = _mm256_mul_pd(direction(i), depth);
                _mm256_sub_pd(_mm256_mul_pd(from_origin(i), direction(2)), along)
            };
            Corners { x: moved(0), y: moved(1), depth }
        }
    }
}

#[inline(always)]
fn edge(p: &Corners, q: &Corners) -> __m256d {
    // SAFETY: only called where the machine has AVX2.
    unsafe { _mm256_sub_pd(_mm256_mul_pd(p.x, q.y), _mm256_mul_pd(p.y, q.x)) }
}

/// Meets triangles in turn where a ray passes through an edge, as far as rounded products tell.
#[cold]
#[inline(never)]
fn meet_in_turn_rarely(block: &Block, candidates: u32, ray: &Ray, limit: f32) -> Hits<LEAF> {
    meet_in_turn(block, candidates, ray, limit)
}
