//! Points on surfaces, and rays that leave them.

use crate::{Ray, Vec3};

/// The unit roundoff of f32, 2⁻²⁴.
const ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// See [`SurfaceSite::flat`].
const MIXED: f32 = 1.0 / (1 << 30) as f32;

/// A few thousand roundings in double precision.
const PRECISE: f32 = 1.0 / (1_u64 << 40) as f32;

/// A point on a surface with a bound on its rounding error per axis, and the
/// unit front normal.
///
/// `error` also covers what the intersection of its own surface rounds when a
/// ray starts there, so a ray from [`ray_origin`](Self::ray_origin) never meets
/// the surface it leaves.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceSite {
    /// The position, in metres.
    pub position: Vec3,
    /// A bound on the error of the position along each axis, in metres.
    pub error: Vec3,
    /// Unit normal of the front.
    pub normal: Vec3,
}

impl SurfaceSite {
    /// A site on a surface that reaches as far as `extent` along each axis from
    /// any of its points.
    ///
    /// With roundoff ε, a coordinate is a sum with a few ε of its own size and
    /// of the extent's (Higham's γₙ ≈ nε, n ≤ 4 here); evaluating the surface's
    /// equation at a distance up to the extent rounds another 5ε of it. The
    /// constants are the next powers of two, the last with room for a normal
    /// that is rounded too.
    pub(crate) fn new(position: Vec3, normal: Vec3, extent: Vec3) -> Self {
        let error = position.abs() * (4.0 * ROUNDOFF) + extent.abs() * (16.0 * ROUNDOFF);
        Self { position, error, normal }
    }

    /// A site on a flat surface whose intersection mixes the coordinates.
    ///
    /// In a plane of coordinates the bound per axis vanishes along the normal, and
    /// rightly: the position is exact there. What is left are the roundings of the
    /// intersection in double precision, 2⁻⁵³ of the extent e, times e² over the area
    /// in slivers, times as much again where a coplanar neighbour is the larger by so
    /// much. 2⁻³⁰ of the extent has room for a factor of 2²⁰ of both, and is a
    /// thousandth of what the bound per axis amounts to in other planes.
    pub(crate) fn flat(position: Vec3, normal: Vec3, extent: Vec3) -> Self {
        Self::new(position, normal, extent).with_error(extent.max_element() * MIXED)
    }

    /// A site that was computed in double precision and rounded once, on a surface of
    /// this size that is met in double precision, too. `bend` is how far roundings
    /// along the surface lead off it.
    pub(crate) fn precise(position: Vec3, normal: Vec3, size: f32, bend: f32) -> Self {
        let error = position.abs() * (2.0 * ROUNDOFF);
        Self { position, error, normal }.with_error(size * PRECISE + bend)
    }

    /// The site with an error that reaches further along the normal by `more`.
    ///
    /// |n|·|n| is one: the error box, projected onto the normal, grows by so
    /// much.
    pub(crate) fn with_error(self, more: f32) -> Self {
        Self { error: self.error + self.normal.abs() * more, ..self }
    }

    /// Returns the origin of a ray toward `direction` (of any length): off the surface, on the side
    /// the direction points to, beyond the rounding error of the position and of this very
    /// addition.
    ///
    /// The error box is projected onto the normal, as in Pharr, Jakob and
    /// Humphreys, *Physically Based Rendering*, 4th ed., section 6.8.
    #[inline]
    pub fn ray_origin(&self, direction: Vec3) -> Vec3 {
        self.lifted(direction, Vec3::ZERO)
    }

    /// The segment between two sites, blocked by neither of their surfaces, on
    /// the sides that face each other.
    ///
    /// The far end is also lifted by the rounding error of the segment's own
    /// direction, which grows with its length.
    #[inline]
    pub fn segment_to(&self, other: &Self) -> Ray {
        let between = other.position - self.position;
        let reach = between.abs() * (8.0 * ROUNDOFF);
        Ray::segment(self.ray_origin(between), other.lifted(-between, reach))
    }

    /// The segment from this site to a point in free space (a point light), not
    /// blocked by the surface it leaves.
    pub fn segment_to_point(&self, point: Vec3) -> Ray {
        Ray::segment(self.ray_origin(point - self.position), point)
    }

    /// The segment from a point in free space (a pinhole) to this site, not
    /// blocked by the surface it reaches.
    pub fn segment_from_point(&self, point: Vec3) -> Ray {
        let between = self.position - point;
        let reach = between.abs() * (8.0 * ROUNDOFF);
        Ray::segment(point, self.lifted(-between, reach))
    }

    /// The position moved along the normal to the side of `direction`, by the
    /// error, the rounding of this addition, and `more` per axis.
    #[inline]
    fn lifted(&self, direction: Vec3, more: Vec3) -> Vec3 {
        let height = self.height() + self.normal.abs().dot(more);
        self.position + self.normal * height.copysign(self.normal.dot(direction))
    }

    /// Returns the distance off the surface at which rays start: the error and the rounding of that
    /// addition, projected onto the normal.
    #[inline]
    pub(crate) fn height(&self) -> f32 {
        let rounding = self.position.abs() * (2.0 * ROUNDOFF);
        self.normal.abs().dot(self.error + rounding)
    }
}

#[cfg(test)]
mod tests;
