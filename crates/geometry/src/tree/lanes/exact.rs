//! The intersection of the rays of a packet with a triangle, in double precision.

use super::triangles::PacketTriangles;
use crate::tree::block::Block;
use crate::tree::intersector::Hits;
use crate::tree::simd::{F32x8, F64x8, Float, PACKET, Simd};

type F64x8Of<E> = <<E as Simd>::F32x8 as F32x8>::F64x8;

/// A corner as each ray sees it: see [`watertight`](crate::watertight).
#[derive(Clone, Copy)]
struct Corner<D> {
    place: [D; 2],
    depth: D,
}

impl<E: Simd> PacketTriangles<E> {
    /// [`watertight::meet`](crate::watertight::meet) for each ray that has a bit and a
    /// triangle of a block; `None` where rounding decides for one of them.
    #[inline(always)]
    pub(crate) fn meet(
        &self,
        block: &Block,
        lane: usize,
        candidates: u32,
        limits: &[f32; PACKET],
    ) -> Option<Hits<PACKET>> {
        let [x, y, longest] = self.direction;
        let direction = [x.widen(), y.widen(), longest.widen()];
        let [a, b, c] = block.picked(lane, self.axes);
        let (a, b, c) =
            (self.corner(a, direction), self.corner(b, direction), self.corner(c, direction));
        let edges @ [of_a, of_b, of_c] = [b.cross(c), c.cross(a), a.cross(b)];
        let zero = self.simd.splat_double(0.0);
        let (least, greatest) = (Float::least(edges), Float::greatest(edges));
        let inside = zero.below(least) | greatest.below(zero);
        let outside = least.below(zero) & zero.below(greatest);
        if (inside | outside) & candidates != candidates {
            return None;
        }
        let scale = self.simd.splat_double(1.0) / ((of_a + of_b + of_c) * direction[2]);
        let t = ((of_a * a.depth + of_b * b.depth + of_c * c.depth) * scale).narrow();
        let share = scale * direction[2];
        let counts = self.simd.splat(0.0).below(t) & t.below(self.simd.load(*limits));
        Some(Hits {
            mask: inside & counts & candidates,
            t: t.to_array(),
            u: (of_b * share).narrow().to_array(),
            v: (of_c * share).narrow().to_array(),
        })
    }

    /// Returns a corner as rays see it, in double precision.
    #[inline(always)]
    fn corner(&self, corner: [f32; 3], direction: [F64x8Of<E>; 3]) -> Corner<F64x8Of<E>> {
        let [x, y, depth] = [0, 1, 2].map(|i| f64::from(corner[i]) - f64::from(self.origin[i]));
        let x = self.simd.splat_double(x);
        let y = self.simd.splat_double(y);
        let depth = self.simd.splat_double(depth);
        let place =
            [x * direction[2] - direction[0] * depth, y * direction[2] - direction[1] * depth];
        Corner { place, depth }
    }
}

impl<D: F64x8> Corner<D> {
    /// Twice the area between a ray, this corner and the next.
    #[inline(always)]
    fn cross(self, next: Self) -> D {
        self.place[0] * next.place[1] - self.place[1] * next.place[0]
    }
}
