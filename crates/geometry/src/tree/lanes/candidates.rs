//! The triangles that the rays of a packet may meet.

use super::triangles::{Corners, PacketTriangles, arrays};
use crate::tree::block::Block;
use crate::tree::extents::{ERROR_BY_DEPTH, ERROR_BY_SIZE};
use crate::tree::intersector::FARTHER;
use crate::tree::mask::{bytes, ones};
use crate::tree::node::LEAF;
use crate::tree::simd::{F32x4, F32x8, Float, PACKET, Simd};
use std::hint::black_box;

/// Triangles as all rays see them.
struct Reach {
    /// From the origin, in the order of the axes.
    corners: Corners,
    /// Along the longest coordinate.
    nearest: [f32; LEAF],
    /// The bound on the rounding error of edge functions.
    error_bound: [f32; LEAF],
    /// One bit for each that is not behind.
    in_front: u32,
}

impl<E: Simd> PacketTriangles<E> {
    /// The triangles of a block that rays may meet at 0 < t < their limit: the place of each
    /// with one bit for each ray that has one in `active`. Perhaps others too:
    /// [`meet`](Self::meet) has the last word.
    #[inline(always)]
    pub(crate) fn candidates(
        &self,
        block: &Block,
        active: u32,
        limits: &[f32; PACKET],
    ) -> impl Iterator<Item = (usize, u32)> + use<E> {
        let reach = self.reach(block);
        let Reach { corners, nearest, error_bound, in_front } = black_box(&reach);
        let limits = self.simd.load(*limits) * self.simd.splat(FARTHER);
        let mut all = 0;
        for lane in ones(*in_front) {
            let edges = self.edges(corners, lane % LEAF, E::F32x8::minus_about);
            let error_bound = self.simd.splat(error_bound[lane % LEAF]);
            let nearest = self.simd.splat(nearest[lane % LEAF]);
            // Products may vanish that are not zero; what is not a number is not decided.
            let nothing = self.simd.splat(-f32::MIN_POSITIVE);
            let outside = (E::F32x8::least(edges) + error_bound).below(nothing)
                & (error_bound - E::F32x8::greatest(edges)).below(nothing);
            let reached = (nearest * self.reciprocal.abs()).below(limits);
            all |= (reached & !outside & active) << (PACKET * lane);
        }
        bytes(all)
    }

    #[inline(always)]
    fn reach(&self, block: &Block) -> Reach {
        let corners = self.relative(block);
        let in_front = self.simd.splat_four(self.in_front);
        let depths = [corners[0][2] * in_front, corners[1][2] * in_front, corners[2][2] * in_front];
        let farthest = E::F32x4::greatest(depths);
        let size = self.simd.load_four(block.words.map(|word| self.extents.size(word)));
        Reach {
            corners: arrays(corners),
            nearest: E::F32x4::least(depths).to_array(),
            error_bound: self.error_bound(size, farthest).to_array(),
            in_front: self.simd.splat_four(0.0).below(farthest),
        }
    }

    /// Bounds the rounding error of edge functions of triangles: of what a ray sees, see
    /// [`candidates`](crate::tree::intersector::TriangleIntersector::candidates).
    #[inline(always)]
    fn error_bound(&self, size: E::F32x4, depth: E::F32x4) -> E::F32x4 {
        let by_depth = depth * self.simd.splat_four(ERROR_BY_DEPTH);
        let by_size = size * self.simd.splat_four(ERROR_BY_SIZE);
        (size + by_depth) * (by_size + by_depth)
    }
}
