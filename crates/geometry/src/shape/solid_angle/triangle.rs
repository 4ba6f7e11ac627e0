//! Triangles.

use super::{LEAST, is_far};
use crate::precise::difference;
use crate::shape::even_pdf;
use crate::{SurfaceSite, Triangle, Vec2, Vec3};
use traylib_math::AreaPdf;

/// A triangle seen from a point in front of it.
///
/// Arvo, *Stratified Sampling of Spherical Triangles*, 1995, with half angles by Peters, *BRDF
/// Importance Sampling for Polygonal Lights*, 2021, which need no angle at a corner and
/// keep their digits however thin the triangle is.
pub(crate) struct SphericalTriangle {
    /// One over the distance of each corner.
    nearness: [f64; 3],
    /// Cosines of the arcs from the first corner to the second, from there to the third, and
    /// from the third to the first.
    cosines: [f64; 3],
    /// Six times the volume between the viewpoint and the three directions.
    volume: f64,
    /// In steradians.
    half_solid_angle: f64,
}

impl SphericalTriangle {
    /// Returns the front as `from` sees it; `None` where the view is too narrow to be parted
    /// evenly, and where sampling by area is as good.
    #[inline]
    pub(crate) fn seen(triangle: &Triangle, from: Vec3) -> Option<Self> {
        let [a, b, c] = triangle.corners();
        let (ab, ac) = (b - a, c - a);
        let squares = [ab, ac, ac - ab].map(Vec3::length_squared);
        let width_squared = squares[0].max(squares[1]).max(squares[2]);
        let centre = (a - from) + (ab + ac) * (1.0 / 3.0);
        if is_far(width_squared, centre) { None } else { Self::seen_near(triangle, from) }
    }

    /// Makes it of what is near: apart, so that the question costs little.
    #[inline(never)]
    fn seen_near(triangle: &Triangle, from: Vec3) -> Option<Self> {
        let corners @ [a, b, c] = triangle.corners().map(|corner| difference(corner, from));
        let height = -a.dot((b - a).cross(c - a));
        if height <= 0.0 {
            return None;
        }
        let nearness = corners.map(|corner| corner.length().recip());
        let arc = |i: usize, j: usize| corners[i].dot(corners[j]) * (nearness[i] * nearness[j]);
        let cosines = [arc(0, 1), arc(1, 2), arc(2, 0)];
        let volume = height * (nearness[0] * nearness[1] * nearness[2]);
        // Van Oosterom and Strackee, *The Solid Angle of a Plane Triangle*, 1983.
        let half_solid_angle = volume.atan2(1.0 + cosines[0] + cosines[1] + cosines[2]);
        let is_wide = 2.0 * half_solid_angle >= LEAST;
        is_wide.then_some(Self { nearness, cosines, volume, half_solid_angle })
    }

    /// A point of what `from` sees, uniform in solid angle, and its density; `None` where
    /// a triangle is not sampled so.
    pub(crate) fn sample_site(
        triangle: &Triangle,
        from: Vec3,
        u: Vec2,
    ) -> Option<(SurfaceSite, AreaPdf)> {
        let seen = Self::seen(triangle, from)?;
        let at = seen.sample(u);
        let site = triangle.site(at.x, at.y);
        Some((site, even_pdf(seen.solid_angle(), from, site.position, site.normal)))
    }

    /// In steradians.
    pub(crate) fn solid_angle(&self) -> f32 {
        2.0 * self.half_solid_angle as f32
    }

    /// Barycentric coordinates, of the second and the third corner, of a point that is
    /// uniform in solid angle.
    pub(crate) fn sample(&self, u: Vec2) -> Vec2 {
        let Self { nearness, cosines: [first_second, second_third, third_first], volume, .. } =
            *self;
        // The arc between the second and the third corner is cut so that this part of the
        // solid angle lies between the second corner and the cut: half of the way there, the
        // direction is a sum of the two corners' directions.
        let (sine, cosine) = (f64::from(u.x) * self.half_solid_angle).sin_cos();
        let half_second = volume * cosine - (second_third + third_first) * sine;
        let half_third = (1.0 + first_second) * sine;
        let square = half_second * half_second
            + half_third * half_third
            + 2.0 * half_second * half_third * second_third;
        let twice = 2.0 * (half_second + half_third * second_third) / square;
        let [cut_second, cut_third] = [twice * half_second - 1.0, twice * half_third];
        // The direction on the arc from the first corner to the cut is uniform in its cosine.
        let whole = cut_second * first_second + cut_third * third_first;
        let cosine = 1.0 - f64::from(u.y) * (1.0 - whole);
        let cut = (f64::from(u.y) * (1.0 + cosine) / (1.0 + whole)).sqrt();
        let weights = [cosine - cut * whole, cut * cut_second, cut * cut_third];
        barycentric(weights, nearness)
    }
}

/// The coordinates of the point in the direction that is this sum of the corners' directions.
fn barycentric(directions: [f64; 3], nearness: [f64; 3]) -> Vec2 {
    let part = |i: usize| (directions[i] * nearness[i]).max(0.0);
    let parts = [part(0), part(1), part(2)];
    let all = parts[0] + parts[1] + parts[2];
    // Nowhere at all by rounding: its middle.
    let scale = if all.is_normal() { all.recip() } else { return Vec2::splat(1.0 / 3.0) };
    Vec2::new((parts[1] * scale) as f32, (parts[2] * scale) as f32)
}
