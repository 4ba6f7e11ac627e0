//! Where the rays of a fan meet a triangle, in single precision.

use super::sight::{Corners, Sight};
use crate::tree::eights::{EIGHT, Eights, Numbers, Single};
use crate::tree::lanes::Hits;

impl<E: Eights> Sight<E> {
    /// [`Flat::meet`](crate::coarse::Flat::meet) for each ray that has a bit and a triangle of
    /// a block; and those rays that pass it where rounding decides.
    #[inline(always)]
    pub(crate) fn meet_fast(
        &self,
        corners: &Corners,
        lane: usize,
        active: u32,
        limits: &[f32; EIGHT],
    ) -> Option<(Hits<EIGHT>, u32)> {
        let edges = self.edges(corners, lane, E::Single::minus_product);
        let [of_a, of_b, of_c] = edges;
        let (zero, limits) = (self.eights.splat(0.0), self.eights.load(*limits));
        let a = self.eights.splat(corners[0][2][lane]) * self.reciprocal;
        let b = self.eights.splat(corners[1][2][lane]) * self.reciprocal;
        let c = self.eights.splat(corners[2][2][lane]) * self.reciprocal;
        let (first, last) = (E::Single::least([a, b, c]), E::Single::greatest([a, b, c]));
        let (least, greatest) = (E::Single::least(edges), E::Single::greatest(edges));
        let inside = zero.at_most(least) | greatest.at_most(zero);
        let passed = inside & zero.below(last) & first.below(limits) & active;
        if passed == 0 {
            return None;
        }
        let settled = zero.below(least) | greatest.below(zero);
        let reciprocal = (of_a + of_b + of_c).reciprocal();
        let sum = of_a * a + of_b * b + of_c * c;
        // Between the nearest corner and the farthest; what is not a number stays.
        let t = last.lesser(first.greater(sum * reciprocal));
        let counts = zero.below(t) & t.below(limits);
        let hits = Hits {
            mask: passed & settled & counts,
            t: t.to_array(),
            u: (of_b * reciprocal).to_array(),
            v: (of_c * reciprocal).to_array(),
        };
        Some((hits, passed & !settled))
    }
}
