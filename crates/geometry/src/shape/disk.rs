//! Flat disks.

use super::{ShapeHit, Sides, all_finite, sound_area};
use crate::precise::{unit, wide};
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};
use std::f64::consts::PI;
use traylib_math::{Frame, warp};

/// A flat disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    centre: Vec3,
    normal: Vec3,
    radius: f32,
}

impl Disk {
    /// The disk with this centre, front normal (of any length) and radius.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NoNormal`], [`Error::NoRadius`], or
    /// [`Error::NoArea`] when the radius is beyond all measure.
    pub fn new(centre: Vec3, normal: Vec3, radius: f32) -> Result<Self, Error> {
        all_finite(&[centre, normal, Vec3::splat(radius), centre.abs() + radius])?;
        if radius <= 0.0 {
            return Err(Error::NoRadius);
        }
        sound_area(PI * f64::from(radius).powi(2))?;
        let normal = unit(wide(normal)).ok_or(Error::NoNormal)?;
        Ok(Self { centre, normal, radius })
    }

    /// The centre.
    pub fn centre(&self) -> Vec3 {
        self.centre
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The radius.
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let rounding = (self.centre.abs() + self.radius) * f32::EPSILON;
        Aabb::around([self.centre]).grown(self.extent() + rounding)
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        (PI * f64::from(self.radius).powi(2)) as f32
    }

    /// Where a ray meets it.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let slope = ray.direction.dot(self.normal);
        let from_centre = ray.origin - self.centre;
        let t = -from_centre.dot(self.normal) / slope;
        if !(ray.contains(t) && sides.admit(slope)) {
            return None;
        }
        let inside = (from_centre + t * ray.direction).length_squared() <= self.radius.powi(2);
        inside.then_some(ShapeHit { t, u: 0.0, v: 0.0 })
    }

    /// The site nearest to where the ray is at `t`.
    pub(crate) fn site(&self, ray: &Ray, t: f32) -> SurfaceSite {
        let near = (ray.origin - self.centre) + t * ray.direction;
        self.site_at(near - self.normal * near.dot(self.normal))
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        let place = self.radius * warp::uniform_disk(u);
        let frame = Frame::around(self.normal);
        self.site_at(frame.x * place.x + frame.y * place.y)
    }

    /// The site at an offset from the centre that lies in the plane.
    fn site_at(&self, from_centre: Vec3) -> SurfaceSite {
        SurfaceSite::new(self.centre + from_centre, self.normal, 2.0 * self.extent())
    }

    /// How far it reaches from its centre along each axis: r·√(1 − nᵢ²), with
    /// 1 − nᵢ² from the other two so that it does not cancel.
    fn extent(&self) -> Vec3 {
        let Vec3 { x, y, z } = self.normal;
        self.radius * Vec3::new(y.hypot(z), z.hypot(x), x.hypot(y))
    }
}
