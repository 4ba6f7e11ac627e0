//! The intersection of the rays of a packet with a triangle, in single precision.

use super::triangles::{Corners, PacketTriangles};
use crate::tree::intersector::Hits;
use crate::tree::simd::{F32x8, Float, PACKET, Simd};

impl<E: Simd> PacketTriangles<E> {
    /// [`ShearedTriangle::meet`](crate::f32_filter::ShearedTriangle::meet) for each ray that has a
    /// bit and a triangle of a block; and those rays that pass it where rounding decides.
    #[inline(always)]
    pub(crate) fn meet_fast(
        &self,
        corners: &Corners,
        lane: usize,
        active: u32,
        limits: &[f32; PACKET],
    ) -> Option<(Hits<PACKET>, u32)> {
        let edges = self.edges(corners, lane, E::F32x8::minus_product);
        let [of_a, of_b, of_c] = edges;
        let (zero, limits) = (self.simd.splat(0.0), self.simd.load(*limits));
        let a = self.simd.splat(corners[0][2][lane]) * self.reciprocal;
        let b = self.simd.splat(corners[1][2][lane]) * self.reciprocal;
        let c = self.simd.splat(corners[2][2][lane]) * self.reciprocal;
        let (first, last) = (E::F32x8::least([a, b, c]), E::F32x8::greatest([a, b, c]));
        let (least, greatest) = (E::F32x8::least(edges), E::F32x8::greatest(edges));
        let inside = zero.at_most(least) | greatest.at_most(zero);
        let filtered = inside & zero.below(last) & first.below(limits) & active;
        if filtered == 0 {
            return None;
        }
        let settled = zero.below(least) | greatest.below(zero);
        let reciprocal = (of_a + of_b + of_c).reciprocal();
        let sum = of_a * a + of_b * b + of_c * c;
        // Between the nearest corner and the farthest; what is not a number stays.
        let t = last.lesser(first.greater(sum * reciprocal));
        let counts = zero.below(t) & t.below(limits);
        let hits = Hits {
            mask: filtered & settled & counts,
            t: t.to_array(),
            u: (of_b * reciprocal).to_array(),
            v: (of_c * reciprocal).to_array(),
        };
        Some((hits, filtered & !settled))
    }
}
