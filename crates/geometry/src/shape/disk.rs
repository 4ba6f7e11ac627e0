//! Flat disks and rings.

use super::{ShapeHit, Sides, all_finite, sound_area};
use crate::precise::{difference, unit};
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};
use std::f64::consts::PI;
use traylib_math::{Frame, warp};

/// The part of its radius by which a disk counts as wider: a few roundings of what it meets.
const WIDER: f64 = 4.0 * f32::EPSILON as f64;

/// A flat disk, or the ring that is left of one without a smaller disk around
/// its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    centre: Vec3,
    normal: Vec3,
    radius: f32,
    inner_radius: f32,
}

impl Disk {
    /// The disk with this centre, front normal (of any length) and radius.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NoNormal`], [`Error::NoRadius`], or
    /// [`Error::NoArea`] when the radius is beyond all measure.
    pub fn new(centre: Vec3, normal: Vec3, radius: f32) -> Result<Self, Error> {
        Self::ring(centre, normal, 0.0, radius)
    }

    /// The points of the plane through `centre` across `normal` (of any length)
    /// whose distance from the centre is between `inner` and `outer`; all of
    /// the disk if `inner` is zero.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NoNormal`], [`Error::NoRadius`] unless
    /// 0 ≤ `inner` and 0 < `outer`, or [`Error::NoArea`] unless `inner` < `outer`
    /// with an area between them that can be measured.
    pub fn ring(centre: Vec3, normal: Vec3, inner: f32, outer: f32) -> Result<Self, Error> {
        all_finite(&[centre, normal, Vec3::splat(inner), centre.abs() + outer])?;
        if inner < 0.0 || outer <= 0.0 {
            return Err(Error::NoRadius);
        }
        if inner >= outer {
            return Err(Error::NoArea);
        }
        sound_area(area_between(inner, outer))?;
        let normal = unit(normal.as_dvec3()).ok_or(Error::NoNormal)?;
        Ok(Self { centre, normal, radius: outer, inner_radius: inner })
    }

    /// The centre.
    pub fn centre(&self) -> Vec3 {
        self.centre
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The radius, of a ring the outer one.
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// The radius of the hole: zero unless it is a ring.
    pub fn inner_radius(&self) -> f32 {
        self.inner_radius
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let rounding = (self.centre.abs() + self.radius) * f32::EPSILON;
        Aabb::around([self.centre]).grown(self.extent() + rounding)
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        area_between(self.inner_radius, self.radius) as f32
    }

    /// Returns the hit of a ray with it.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let (direction, normal) = (ray.direction.as_dvec3(), self.normal.as_dvec3());
        let slope = direction.dot(normal);
        let from_centre = difference(ray.origin, self.centre);
        let exact = -from_centre.dot(normal) / slope;
        let t = exact as f32;
        if !(ray.contains(t) && sides.admit(slope as f32)) {
            return None;
        }
        let square = (from_centre + exact * direction).length_squared();
        let [least, most] = self.reach_squared();
        let inside = least <= square && square <= most;
        inside.then_some(ShapeHit { t, u: 0.0, v: 0.0 })
    }

    /// From which to which square of the distance to the centre it is met.
    #[inline]
    pub(crate) fn reach_squared(&self) -> [f64; 2] {
        let [inner, outer] = [self.inner_radius, self.radius].map(f64::from);
        // A little wider, so that light does not pass where it meets what it closes.
        [inner * (1.0 - WIDER), outer * (1.0 + WIDER)].map(|radius| radius * radius)
    }

    /// The site nearest to where the ray is at `t`.
    pub(crate) fn site(&self, ray: &Ray, t: f32) -> SurfaceSite {
        let near = (ray.origin - self.centre) + t * ray.direction;
        self.site_at(near - self.normal * near.dot(self.normal))
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        let hole = (self.inner_radius / self.radius).powi(2);
        // The square of the distance is uniform, from the hole's to one.
        let beyond = Vec2::new(hole + u.x * (1.0 - hole), u.y);
        let place = self.radius * warp::uniform_disk(beyond);
        let frame = Frame::around(self.normal);
        self.site_at(frame.x * place.x + frame.y * place.y)
    }

    /// The site at an offset from the centre that lies in the plane.
    fn site_at(&self, from_centre: Vec3) -> SurfaceSite {
        SurfaceSite::new(self.centre + from_centre, self.normal, 2.0 * self.extent())
    }

    /// Returns the extent from its centre along each axis: r·√(1 − nᵢ²), with 1 − nᵢ² from the
    /// other two so that it does not cancel.
    fn extent(&self) -> Vec3 {
        let Vec3 { x, y, z } = self.normal;
        self.radius * Vec3::new(y.hypot(z), z.hypot(x), x.hypot(y))
    }
}

/// π(R² − r²), of a thin ring too.
fn area_between(inner: f32, outer: f32) -> f64 {
    let (inner, outer) = (f64::from(inner), f64::from(outer));
    PI * ((outer - inner) * (outer + inner))
}
