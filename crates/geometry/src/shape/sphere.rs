//! Spheres.

use super::{Facing, ShapeHit, Sides, all_finite, bend, even_pdf, sound_area};
use crate::precise::{DVec3, difference};
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};
use std::f32::consts::TAU;
use std::f64::consts::PI;
use traylib_math::{AreaPdf, Frame, warp};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    centre: Vec3,
    radius: f32,
    facing: Facing,
}

impl Sphere {
    /// The sphere with this centre, radius and front.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NoRadius`], or [`Error::NoArea`] when the
    /// radius is beyond all measure.
    pub fn new(centre: Vec3, radius: f32, facing: Facing) -> Result<Self, Error> {
        all_finite(&[centre, Vec3::splat(radius), centre.abs() + radius])?;
        if radius <= 0.0 {
            return Err(Error::NoRadius);
        }
        sound_area(4.0 * PI * f64::from(radius).powi(2))?;
        Ok(Self { centre, radius, facing })
    }

    /// The centre.
    pub fn centre(&self) -> Vec3 {
        self.centre
    }

    /// The radius.
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// Returns the side that is the front.
    pub fn facing(&self) -> Facing {
        self.facing
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let rounding = (self.centre.abs() + self.radius) * f32::EPSILON;
        Aabb::around([self.centre]).grown(rounding + self.radius)
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        (4.0 * PI * f64::from(self.radius).powi(2)) as f32
    }

    /// Returns the first hit of a ray with it.
    ///
    /// The discriminant comes from the distance between centre and ray and the
    /// roots from a sum of equal signs, so that neither a far camera nor a
    /// tiny sphere cancels: Haines et al., *Precision Improvements for
    /// Ray/Sphere Intersection*, Ray Tracing Gems, 2019, chapter 7. In double
    /// precision no product of lengths overflows, and a ball as large as the
    /// earth is as smooth as a small one.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let from_centre = difference(ray.origin, self.centre);
        let direction = ray.direction.as_dvec3();
        let radius_squared = self.radius_squared();
        let square = direction.length_squared();
        // The cross product is the distance between centre and line, times |d|.
        let beside = from_centre.cross(direction).length_squared();
        let room = radius_squared * square - beside;
        // NaN has no root either.
        if room.is_nan() || room < 0.0 {
            return None;
        }
        let along = -from_centre.dot(direction);
        let outside = from_centre.length_squared() - radius_squared;
        let sum = along + room.sqrt().copysign(along);
        let (one, other) = ((outside / sum) as f32, (sum / square) as f32);
        // By the sign that the sum has, which zero has too: a ray from the centre.
        let behind = along.is_sign_negative();
        let (enter, leave) = if behind { (other, one) } else { (one, other) };
        let t = match (sides, self.facing) {
            (Sides::Both, _) if ray.contains(enter) => enter,
            (Sides::Both, _) | (Sides::Front, Facing::Inward) => leave,
            (Sides::Front, Facing::Outward) => enter,
        };
        ray.contains(t).then_some(ShapeHit { t, u: 0.0, v: 0.0 })
    }

    /// The site nearest to where the ray is at `t`.
    pub(crate) fn site(&self, ray: &Ray, t: f32) -> SurfaceSite {
        let near = difference(ray.origin, self.centre) + f64::from(t) * ray.direction.as_dvec3();
        self.site_along(near)
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        self.site_toward(warp::uniform_sphere(u))
    }

    /// A point uniform in the cone of directions that `from` sees the sphere
    /// in, and its density; `None` where that is not how the sphere is sampled.
    pub(crate) fn sample_cone(&self, from: Vec3, u: Vec2) -> Option<(SurfaceSite, AreaPdf)> {
        let cone = SubtendedCone::toward(self, from)?;
        let one_minus_cos = u.x * cone.one_minus_cos;
        let cos = 1.0 - one_minus_cos;
        let sin = (one_minus_cos * (2.0 - one_minus_cos)).sqrt();
        // Sine of the angle at the sphere between the ray and its normal; the
        // angle at the centre is the difference of the two.
        let sin_at = (sin / cone.sin).min(1.0);
        let cos_at = (1.0 - sin_at * sin_at).sqrt();
        let cos_centre = cos_at * cos + sin_at * sin;
        let sin_centre = (sin_at * cos - cos_at * sin).max(0.0);
        let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
        let local = Vec3::new(sin_centre * cos_phi, sin_centre * sin_phi, cos_centre);
        let site = self.site_toward(Frame::around(-cone.axis).to_world(local));
        Some((site, cone.pdf(from, site.position, site.normal)))
    }

    /// Density per area of [`sample_cone`](Self::sample_cone) at a point with
    /// this position and normal: zero where the sphere turns away.
    pub(crate) fn pdf_cone(&self, from: Vec3, position: Vec3, normal: Vec3) -> Option<AreaPdf> {
        Some(SubtendedCone::toward(self, from)?.pdf(from, position, normal))
    }

    /// The site in this direction, of any length, from the centre.
    fn site_along(&self, direction: DVec3) -> SurfaceSite {
        self.site_at(direction.normalize_or(DVec3::Z))
    }

    /// The site in a direction that is of length one up to roundings.
    ///
    /// An error of δ becomes one of 3/8 δ² by one step of Newton's method for 1/√x.
    fn site_toward(&self, direction: Vec3) -> SurfaceSite {
        let direction = direction.as_dvec3();
        self.site_at(direction * (1.5 - 0.5 * direction.length_squared()))
    }

    /// The site in this direction of length one.
    fn site_at(&self, outward: DVec3) -> SurfaceSite {
        let position = self.centre.as_dvec3() + f64::from(self.radius) * outward;
        let normal = self.facing.turn(outward.as_vec3());
        let bend = bend(position, f64::from(self.radius));
        SurfaceSite::precise(position.as_vec3(), normal, self.radius, bend)
    }

    pub(crate) fn radius_squared(&self) -> f64 {
        f64::from(self.radius) * f64::from(self.radius)
    }
}

/// The directions in which a point sees a sphere.
struct SubtendedCone {
    axis: Vec3,
    /// The sine of the half angle.
    sin: f32,
    /// One minus the cosine of the half angle: sin²/(1 + cos), which keeps its digits when small.
    one_minus_cos: f32,
}

impl SubtendedCone {
    /// The cone from a point outside a sphere that faces outward.
    fn toward(sphere: &Sphere, from: Vec3) -> Option<Self> {
        let to_centre = sphere.centre - from;
        let distance_squared = to_centre.length_squared();
        let outside = distance_squared > sphere.radius * sphere.radius;
        if !outside || sphere.facing == Facing::Inward {
            return None;
        }
        let distance = distance_squared.sqrt();
        let sin = sphere.radius / distance;
        let cos = ((1.0 - sin) * (1.0 + sin)).max(0.0).sqrt();
        let one_minus_cos = sin * sin / (1.0 + cos);
        Some(Self { axis: to_centre / distance, sin, one_minus_cos })
    }

    /// Uniform over the cone, at a point of the sphere with this position and normal.
    fn pdf(&self, from: Vec3, position: Vec3, normal: Vec3) -> AreaPdf {
        even_pdf(TAU * self.one_minus_cos, from, position, normal)
    }
}

#[cfg(test)]
mod tests;
