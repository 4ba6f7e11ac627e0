//! Four spheres.

use super::{Line, NO_ROWS, Rows, ShapeBlock, contained, cross, dot, hits_at, read, write};
use crate::shape::ShapeKind;
use crate::tree::intersector::Hits;
use crate::tree::mask::ones;
use crate::tree::node::LEAF;
use crate::tree::simd::{F32x4, F64x4, Float, Simd};
use crate::{Facing, Sides};

/// Up to four spheres; where there is none, its numbers are none.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct SphereBlock {
    centres: Rows,
    /// The squares of the radii.
    squares: [f64; LEAF],
    numbers: [u32; LEAF],
    /// One bit for each that is met where a ray enters.
    entered: u32,
    /// One bit for each that is met where a ray leaves.
    left: u32,
}

impl SphereBlock {
    pub(crate) fn new(numbers: [u32; LEAF], kind: impl Fn(u32) -> ShapeKind) -> Self {
        let squares = [f64::NAN; LEAF];
        let mut block = Self { centres: NO_ROWS, squares, numbers, entered: 0, left: 0 };
        for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &n)| n != u32::MAX) {
            let ShapeKind::Sphere(sphere, sides) = kind(number) else { continue };
            write(&mut block.centres, lane, sphere.centre().as_dvec3());
            block.squares[lane] = sphere.radius_squared();
            let (entered, left) = match (sides, sphere.facing()) {
                (Sides::Both, _) => (true, true),
                (Sides::Front, Facing::Outward) => (true, false),
                (Sides::Front, Facing::Inward) => (false, true),
            };
            block.entered |= u32::from(entered) << lane;
            block.left |= u32::from(left) << lane;
        }
        block
    }
}

impl ShapeBlock for SphereBlock {
    fn numbers(&self) -> &[u32; LEAF] {
        &self.numbers
    }

    /// [`Sphere::intersect`](crate::Sphere::intersect) of each.
    #[inline(always)]
    fn hits<E: Simd>(&self, line: &Line<E>, limit: f32) -> Hits<LEAF> {
        let simd = line.simd;
        let from_centre = line.origin_from(read(simd, &self.centres));
        let radius_squared = simd.load_four_doubles(self.squares);
        let square = dot(line.direction, line.direction);
        let aside = cross(from_centre, line.direction);
        let room = radius_squared * square - dot(aside, aside);
        let met = simd.splat_four_doubles(0.0).at_most(room);
        if met == 0 {
            return hits_at(0, simd.splat_four(0.0));
        }
        let along = dot(from_centre, line.direction) * simd.splat_four_doubles(-1.0);
        let outside = dot(from_centre, from_centre) - radius_squared;
        let sum = along + room.square_root().with_signs_of(along);
        let (one, other) = ((outside / sum).narrow(), (sum / square).narrow());
        let behind = along.signs();
        let [one_counts, other_counts] = [one, other].map(|t| contained(simd, t, limit) & met);
        let enters = (other_counts & behind | one_counts & !behind) & self.entered;
        let leaves = (one_counts & behind | other_counts & !behind) & self.left & !enters;
        let is_other = enters & behind | leaves & !behind;
        let mut hits = hits_at(enters | leaves, one);
        let others = other.to_array();
        for lane in ones(is_other) {
            hits.t[lane % LEAF] = others[lane % LEAF];
        }
        hits
    }
}
