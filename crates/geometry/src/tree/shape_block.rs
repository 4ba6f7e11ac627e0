//! Quads, spheres and disks, four of a kind side by side.
//!
//! A block meets what [`Quad::intersect`](crate::Quad::intersect) and its likes meet, by the
//! same operations in the same order, so it finds the same bits: written once for all
//! instruction sets, over the numbers of [`Simd`].

mod disks;
mod quads;
mod spheres;
#[cfg(test)]
mod tests;

pub(crate) use disks::DiskBlock;
pub(crate) use quads::QuadBlock;
pub(crate) use spheres::SphereBlock;

use super::intersector::Hits;
use super::mask::ones;
use super::node::LEAF;
use super::simd::{F32x4, F64x4, Float, Simd};
use crate::Ray;
use crate::ShapeHit;
use crate::precise::DVec3;
use std::ops::ControlFlow;

/// Shapes of one kind.
pub(crate) trait ShapeBlock {
    /// Returns the numbers of the shapes.
    fn numbers(&self) -> &[u32; LEAF];

    /// Returns the hits of a ray with them at 0 < t < `limit`.
    fn hits<E: Simd>(&self, line: &Line<E>, limit: f32) -> Hits<LEAF>;

    /// Tells of each hit, and of the number of the shape, until it is told to stop.
    #[inline(always)]
    fn each_hit<E: Simd>(
        &self,
        line: &Line<E>,
        limit: f32,
        mut tell: impl FnMut(u32, ShapeHit) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let hits = self.hits(line, limit);
        ones(hits.mask).try_for_each(|lane| tell(self.numbers()[lane % LEAF], hits.hit(lane)))
    }
}

/// Three coordinates of four shapes, or the same of a ray four times.
type Vectors<D> = [D; 3];

/// A ray in double precision, before four shapes.
#[derive(Clone, Copy)]
pub(crate) struct Line<E: Simd> {
    simd: E,
    origin: Vectors<E::F64x4>,
    direction: Vectors<E::F64x4>,
}

impl<E: Simd> Line<E> {
    #[inline(always)]
    pub(crate) fn of(simd: E, ray: &Ray) -> Self {
        let four = |x: f32| simd.widen_four(simd.splat_four(x));
        Self {
            simd,
            origin: ray.origin.to_array().map(four),
            direction: ray.direction.to_array().map(four),
        }
    }

    /// From points to the origin.
    #[inline(always)]
    fn origin_from(&self, points: Vectors<E::F64x4>) -> Vectors<E::F64x4> {
        let [x, y, z] = self.origin;
        [x - points[0], y - points[1], z - points[2]]
    }
}

#[inline(always)]
fn dot<D: F64x4>(a: Vectors<D>, b: Vectors<D>) -> D {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<D: F64x4>(a: Vectors<D>, b: Vectors<D>) -> Vectors<D> {
    [a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]]
}

#[inline(always)]
fn scaled<D: F64x4>(a: Vectors<D>, by: D) -> Vectors<D> {
    a.map(|x| x * by)
}

/// Returns a mask of those that count; see [`Ray::contains`].
#[inline(always)]
fn contained<E: Simd>(simd: E, t: E::F32x4, limit: f32) -> u32 {
    simd.splat_four(0.0).below(t) & t.below(simd.splat_four(limit))
}

/// Coordinates as blocks keep them: by axis, by shape.
type Rows = [[f64; LEAF]; 3];

/// The rows of no shape: not numbers.
const NO_ROWS: Rows = [[f64::NAN; LEAF]; 3];

fn write(rows: &mut Rows, lane: usize, vector: DVec3) {
    for (row, coordinate) in rows.iter_mut().zip(vector.to_array()) {
        row[lane] = coordinate;
    }
}

#[inline(always)]
fn read<E: Simd>(simd: E, rows: &Rows) -> Vectors<E::F64x4> {
    rows.map(|row| simd.load_four_doubles(row))
}

/// Hits of which only t is to be told.
#[inline(always)]
fn hits_at<F: F32x4>(mask: u32, t: F) -> Hits<LEAF> {
    Hits { mask, t: t.to_array(), u: [0.0; LEAF], v: [0.0; LEAF] }
}
