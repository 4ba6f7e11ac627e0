//! Which triangles the rays of a fan may meet.

use super::sight::{Corners, Sight, arrays};
use crate::tree::block::Block;
use crate::tree::eights::{EIGHT, Eights, Four, Numbers, Single};
use crate::tree::lanes::FARTHER;
use crate::tree::mask::{bytes, ones};
use crate::tree::node::LEAF;
use crate::tree::sizes::{DOUBT_BY_DEPTH, DOUBT_BY_SIZE};
use std::hint::black_box;

/// Triangles as all rays see them.
struct Reach {
    /// From the origin, in the order of the axes.
    corners: Corners,
    /// Along the longest coordinate.
    nearest: [f32; LEAF],
    /// How far edge functions may be off by rounding.
    doubt: [f32; LEAF],
    /// One bit for each that is not behind.
    ahead: u32,
}

impl<E: Eights> Sight<E> {
    /// The triangles of a block that rays may meet at 0 < t < their limit: the place of each
    /// with one bit for each ray that has one in `active`. Perhaps others too:
    /// [`meet`](Self::meet) has the last word.
    #[inline(always)]
    pub(crate) fn candidates(
        &self,
        block: &Block,
        active: u32,
        limits: &[f32; EIGHT],
    ) -> impl Iterator<Item = (usize, u32)> + use<E> {
        let reach = self.reach(block);
        let Reach { corners, nearest, doubt, ahead } = black_box(&reach);
        let limits = self.eights.load(*limits) * self.eights.splat(FARTHER);
        let mut all = 0;
        for lane in ones(*ahead) {
            let edges = self.edges(corners, lane % LEAF, E::Single::minus_about);
            let doubt = self.eights.splat(doubt[lane % LEAF]);
            let nearest = self.eights.splat(nearest[lane % LEAF]);
            // Products may vanish that are not zero; what is not a number stays in doubt.
            let nothing = self.eights.splat(-f32::MIN_POSITIVE);
            let outside = (E::Single::least(edges) + doubt).below(nothing)
                & (doubt - E::Single::greatest(edges)).below(nothing);
            let reached = (nearest * self.reciprocal.abs()).below(limits);
            all |= (reached & !outside & active) << (EIGHT * lane);
        }
        bytes(all)
    }

    #[inline(always)]
    fn reach(&self, block: &Block) -> Reach {
        let corners = self.relative(block);
        let ahead = self.eights.splat_four(self.ahead);
        let depths = [corners[0][2] * ahead, corners[1][2] * ahead, corners[2][2] * ahead];
        let farthest = E::Four::greatest(depths);
        let size = self.eights.load_four(block.words.map(|word| self.sizes.size(word)));
        Reach {
            corners: arrays(corners),
            nearest: E::Four::least(depths).to_array(),
            doubt: self.doubt(size, farthest).to_array(),
            ahead: self.eights.splat_four(0.0).below(farthest),
        }
    }

    /// How far edge functions of triangles may be off by rounding: of what a ray sees, see
    /// [`candidates`](crate::tree::lanes::Triangles::candidates).
    #[inline(always)]
    fn doubt(&self, size: E::Four, depth: E::Four) -> E::Four {
        let by_depth = depth * self.eights.splat_four(DOUBT_BY_DEPTH);
        let by_size = size * self.eights.splat_four(DOUBT_BY_SIZE);
        (size + by_depth) * (by_size + by_depth)
    }
}
