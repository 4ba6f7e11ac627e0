//! Points on surfaces, and rays that leave them.

use crate::{Ray, Vec3};
use traylib_math::{Defect, planted};

/// The unit roundoff of f32, 2⁻²⁴.
const ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// A point on a surface with a bound on its rounding error per axis, and the
/// unit front normal.
///
/// `error` also covers what the intersection of its own surface rounds when a
/// ray starts there, so a ray from [`ray_origin`](Self::ray_origin) never meets
/// the surface it leaves.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceSite {
    /// Where.
    pub position: Vec3,
    /// How far off at most, along each axis.
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

    /// The site with an error that reaches further along the normal by `more`.
    ///
    /// |n|·|n| is one: the error box, projected onto the normal, grows by so
    /// much.
    pub(crate) fn with_error(self, more: f32) -> Self {
        Self { error: self.error + self.normal.abs() * more, ..self }
    }

    /// Where a ray toward `direction` (of any length) may start: off the
    /// surface, on the side the direction points to, beyond the rounding error
    /// of the position and of this very addition.
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
        let rounding = self.position.abs() * (2.0 * ROUNDOFF);
        let height = self.normal.abs().dot(self.error + rounding + more);
        let height = if planted(Defect::AbsoluteEpsilon) { 1e-3 } else { height };
        self.position + self.normal * height.copysign(self.normal.dot(direction))
    }
}

#[cfg(test)]
mod tests;
