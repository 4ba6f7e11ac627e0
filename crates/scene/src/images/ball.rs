//! The image in a ball: small, and near behind its surface.

mod mirroring;

use super::ImageCone;
use super::light_ball::LightBall;
use super::reflection::Reflection;
use mirroring::Mirroring;
use traylib_geometry::Sphere;
use traylib_math::Vec3;
use traylib_math::glam::DVec3;

/// The image's half-angle is computed for its middle: a little more holds the rest.
const AMPLE: f32 = 1.05;
/// Last steps of Newton's method, in radians: no error in double precision, and some 10⁻⁴.
const TO_THE_LAST_BITS: f64 = 1e-9;
const FOR_A_CONE: f64 = 1e-2;

/// A ball that mirrors to its outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BallMirror {
    centre: Vec3,
    radius: f32,
}

impl BallMirror {
    pub(super) fn new(sphere: &Sphere) -> Self {
        Self { centre: sphere.centre(), radius: sphere.radius() }
    }

    pub(super) fn centre(&self) -> Vec3 {
        self.centre
    }

    pub(super) fn radius(&self) -> f32 {
        self.radius
    }

    /// Tells whether a lamp's light may fall on it.
    pub(super) fn may_show(&self, lamp: &LightBall) -> bool {
        lamp.may_light(self.centre, self.radius)
    }

    /// Tells whether any of the ball is above a surface with this normal.
    #[inline]
    pub(super) fn rises_above(&self, from: Vec3, normal: Vec3) -> bool {
        normal.dot(self.centre - from) > -self.radius
    }

    /// The cone around a lamp's image as `from` sees it, if any of it may show.
    pub(super) fn image(&self, lamp: &LightBall, blur: f32, from: Vec3) -> Option<ImageCone> {
        let normal = self.normal_toward(from, lamp.centre)?;
        let seen_at = self.centre + self.radius * normal;
        let (to_eye, to_lamp) = (from - seen_at, lamp.centre - seen_at);
        // On the side of both, up to the lamp's extent, and in the lamp's light.
        if normal.dot(to_eye) <= 0.0
            || normal.dot(to_lamp) <= -lamp.radius
            || !lamp.shines_to(-to_lamp)
        {
            return None;
        }
        let (eye_distance, lamp_distance) = (to_eye.length(), to_lamp.length());
        let cosine = normal.dot(to_eye) / eye_distance;
        // How far the image stands behind the surface, in the plane where that is
        // farther: across the plane of incidence (Coddington's equations).
        let depth = 1.0 / (1.0 / lamp_distance + 2.0 * cosine / self.radius);
        let half_angle =
            AMPLE * (lamp.radius / lamp_distance + blur) * depth / (eye_distance + depth);
        // ½h² is 1 − cos h or a little more.
        Some(ImageCone::around(-to_eye / eye_distance, 0.5 * half_angle * half_angle))
    }

    /// The unit normal where the ball mirrors one point into the other, both outside, or one
    /// near there: where the middle of a lamp is hidden some of it may not be.
    fn normal_toward(&self, one: Vec3, other: Vec3) -> Option<Vec3> {
        let mirroring = Mirroring::between(self.in_radii(one), self.in_radii(other))?;
        let normal = mirroring.normal(FOR_A_CONE).unwrap_or_else(|| mirroring.between_ends());
        Some(normal.as_vec3())
    }

    /// A point from the centre, in radii.
    fn in_radii(&self, point: Vec3) -> DVec3 {
        (point.as_dvec3() - self.centre.as_dvec3()) * f64::from(self.radius).recip()
    }

    /// Returns how light of a point arrives at another by way of the ball.
    ///
    /// A narrow bundle of rays that has come a metres from the light and is mirrored at the
    /// angle θ spreads as if it came from a and a + 2ab/(r·cosθ) in the plane of incidence, and
    /// from 2ab·cosθ/r farther across it (Coddington's equations): b metres on it is
    /// (a + b + 2ab/(r·cosθ))·(a + b + 2ab·cosθ/r) times as wide as the solid angle that it
    /// fills at the light. It is the same from either end.
    pub(super) fn reflection(&self, from: Vec3, light: Vec3) -> Option<Reflection> {
        let [one, other] = [from, light].map(|point| self.in_radii(point));
        let normal = Mirroring::between(one, other)?.normal(TO_THE_LAST_BITS)?;
        let [to_one, to_other] = [one - normal, other - normal];
        let [a, b] = [to_one, to_other].map(DVec3::length);
        let cosine = normal.dot(to_one) / a;
        // Both before the surface.
        if cosine.is_nan() || cosine <= 0.0 || normal.dot(to_other) <= 0.0 {
            return None;
        }
        let bend = 2.0 * a * b;
        let area = (a + b + bend / cosine) * (a + b + bend * cosine);
        let radius = f64::from(self.radius);
        Some(Reflection { toward: -to_one * radius, spread: 1.0 / (area * radius * radius) })
    }
}

#[cfg(test)]
mod tests;
