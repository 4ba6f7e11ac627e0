//! Rays and what they meet.

use crate::Vec3;

/// A half line or a segment: the points `origin + t · direction` with
/// 0 < t < `t_max`.
///
/// A hit counts when 0 < t < `t_max`. The direction need not be unit; t is in
/// units of its length.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ray {
    /// The point at t = 0.
    pub origin: Vec3,
    /// The direction, of any length but zero.
    pub direction: Vec3,
    /// The t at which it ends, in units of the direction's length.
    pub t_max: f32,
}

impl Ray {
    /// A ray without end.
    #[inline]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction, t_max: f32::INFINITY }
    }

    /// The open segment between two points: t is 0 at `from` and 1 at `to`.
    ///
    /// Between two points on surfaces use
    /// [`SurfaceSite::segment_to`](crate::SurfaceSite::segment_to): the
    /// rounding of `to − from` can carry the end of a long segment through the
    /// surface at `to`.
    #[inline]
    pub fn segment(from: Vec3, to: Vec3) -> Self {
        Self { origin: from, direction: to - from, t_max: 1.0 }
    }

    /// The point at `t`.
    #[inline]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }

    /// Tells whether `t` counts; what is not a number does not.
    #[inline]
    pub(crate) fn contains(&self, t: f32) -> bool {
        0.0 < t && t < self.t_max
    }

    /// The coordinates of a direction, all counted as positive, sum up to this at least: the
    /// reciprocal of the longest might be no number otherwise.
    pub(crate) const SMALLEST: f32 = f32::MIN_POSITIVE;

    /// Tells whether there is anything to trace: finite numbers, a direction, a positive length.
    #[inline]
    pub(crate) fn is_traceable(&self) -> bool {
        // Zero for all numbers, and not a number for what is none or infinite.
        let nothing = 0.0 * self.origin + 0.0 * self.direction;
        nothing.x + nothing.y + nothing.z == 0.0
            && self.direction.abs().element_sum() >= Self::SMALLEST
            && self.t_max > 0.0
    }
}

/// The meeting of a ray with one of many shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Hit {
    /// The parameter along the ray, in units of its direction's length.
    pub t: f32,
    /// The number of the shape, in the order the caller listed them.
    pub primitive: u32,
    /// Barycentric coordinate of the second corner on triangles, coordinate
    /// along the first edge on quads, zero elsewhere.
    pub u: f32,
    /// Barycentric coordinate of the third corner on triangles, coordinate
    /// along the second edge on quads, zero elsewhere.
    pub v: f32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_ends_at_its_end() {
        let ray = Ray::segment(Vec3::X, Vec3::new(1.0, 4.0, 0.0));
        assert_eq!(ray.at(0.25), Vec3::new(1.0, 1.0, 0.0));
        assert!(ray.contains(0.999) && !ray.contains(1.0) && !ray.contains(0.0));
    }

    #[test]
    fn rays_that_are_none_are_known() {
        let sound = Ray::new(Vec3::ZERO, Vec3::X);
        assert!(sound.is_traceable());
        for bad in [
            Ray { origin: Vec3::new(0.0, f32::NAN, 0.0), ..sound },
            Ray { direction: Vec3::new(0.0, f32::INFINITY, 0.0), ..sound },
            Ray { direction: Vec3::new(0.0, -0.0, 0.0), ..sound },
            Ray { direction: Vec3::splat(-1e-39), ..sound },
            Ray { t_max: f32::NAN, ..sound },
            Ray { t_max: 0.0, ..sound },
        ] {
            assert!(!bad.is_traceable(), "{bad:?}");
        }
    }
}
