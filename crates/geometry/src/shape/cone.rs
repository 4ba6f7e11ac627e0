//! Truncated cones and cylinders.

mod crossing;

use super::{Facing, ShapeHit, Sides, all_finite, bend, sound_area};
use crate::precise::{DVec3, difference};
use crate::{Aabb, Error, Normals, Ray, SurfaceSite, Vec2, Vec3};
use crossing::crossings;
use std::f64::consts::{PI, TAU};

/// The side of a truncated cone, without its ends: all points around the axis
/// between two points, at a distance from it that goes evenly from the radius
/// at the one to the radius at the other. A cylinder if the radii are equal, a
/// cone with its tip if one is zero.
///
/// It is small and computed in double precision throughout: a wire has a length
/// of many radii, and its radius would drown in the rounding of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    ends: [Vec3; 2],
    radii: [f32; 2],
    facing: Facing,
}

impl Cone {
    /// The cone with these ends of its axis, the radius at each, and front.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::NoRadius`] if one radius is negative or
    /// both are zero; [`Error::NoAxis`] if the ends are the same point; or
    /// [`Error::NoArea`] if the area is beyond all measure.
    pub fn new(ends: [Vec3; 2], radii: [f32; 2], facing: Facing) -> Result<Self, Error> {
        let reach = [ends[0].abs() + radii[0], ends[1].abs() + radii[1]];
        all_finite(&[ends[0], ends[1], reach[0], reach[1]])?;
        let [one, other] = radii;
        if one < 0.0 || other < 0.0 || one + other == 0.0 {
            return Err(Error::NoRadius);
        }
        if ends[0] == ends[1] {
            return Err(Error::NoAxis);
        }
        let cone = Self { ends, radii, facing };
        sound_area(cone.precise_area())?;
        Ok(cone)
    }

    /// The ends of the axis.
    pub fn ends(&self) -> [Vec3; 2] {
        self.ends
    }

    /// The radius at each end.
    pub fn radii(&self) -> [f32; 2] {
        self.radii
    }

    /// Returns the side that is the front.
    pub fn facing(&self) -> Facing {
        self.facing
    }

    /// The smallest box around it, up to rounding.
    pub fn bounds(&self) -> Aabb {
        let rim = self.rim();
        let around = |end: usize| {
            let (centre, reach) = (self.ends[end].as_dvec3(), rim * f64::from(self.radii[end]));
            let margin = (centre.abs() + reach) * (4.0 * f64::EPSILON);
            // One rounding to f32 beyond.
            let outward = |v: DVec3, side: f64| v + side * v.abs() * f64::from(f32::EPSILON);
            let (min, max) = (centre - reach - margin, centre + reach + margin);
            Aabb { min: outward(min, -1.0).as_vec3(), max: outward(max, 1.0).as_vec3() }
        };
        around(0).union(around(1))
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        self.precise_area() as f32
    }

    /// The directions of its front normals: a circle around the axis, never more
    /// than a right angle from the end that it lies nearer to.
    pub(crate) fn normals(&self) -> Normals {
        let (axis, widening) = (self.axis(), self.widening());
        let toward_narrow = (if widening > 0.0 { -axis } else { axis }).normalize().as_vec3();
        let half_angle = axis.length().atan2(widening.abs());
        Normals { axis: self.facing.turn(toward_narrow), half_angle }
    }

    /// The larger of two shadows of its front: of one half seen squarely, and of all
    /// of it seen along the axis.
    ///
    /// With l the axis, w the widening and s = √(l² + w²), a normal is l/s across the
    /// axis and w/s along it. Those within φ ≤ π of one side have the sum sinφ/π·l/s
    /// across and φ/π·w/s along, over all of them; the largest shadow is the largest
    /// length of such a sum. Here are φ = π/2 and φ = π; angles between give up to
    /// 2.1 % more.
    pub(crate) fn largest_shadow(&self) -> f32 {
        let radii = f64::from(self.radii[0]) + f64::from(self.radii[1]);
        let along = PI * self.widening().abs();
        (radii * along.max(self.axis().length().hypot(0.5 * along))) as f32
    }

    /// Returns the first hit of a ray with it.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let hits = crossings(self, ray)?.into_iter().filter_map(|crossing| {
            let t = crossing.t as f32;
            let admitted = sides.admit(self.facing.turn(crossing.cosine_sign));
            let counts = ray.contains(t) && crossing.is_between_ends() && admitted;
            counts.then_some(t)
        });
        hits.min_by(f32::total_cmp).map(|t| ShapeHit { t, u: 0.0, v: 0.0 })
    }

    /// The site where the ray, at about `t`, crosses the surface.
    ///
    /// The crossing is found again in double precision: from afar, the rounding
    /// of `t` alone would turn the normal of a wire.
    pub(crate) fn site(&self, ray: &Ray, t: f32) -> SurfaceSite {
        let t = f64::from(t);
        let away = |exact: f64| (exact - t).abs();
        let exact = crossings(self, ray)
            .map_or(t, |[one, other]| if away(one.t) < away(other.t) { one.t } else { other.t });
        let t = if exact.is_finite() { exact } else { t };
        self.site_near(difference(ray.origin, self.ends[0]) + t * ray.direction.as_dvec3())
    }

    /// A point whose distance from the axis has a density that grows with it.
    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        let [first, last] = self.radii.map(f64::from);
        let (u, turn) = (f64::from(u.x), f64::from(u.y));
        let radius = (first * first + u * (last * last - first * first)).sqrt();
        // (radius − first)/(last − first) without the differences; only where
        // the tip itself is asked for, both sums are zero.
        let height = u * (first + last) / (first + radius).max(f64::MIN_POSITIVE);
        let axis = self.axis();
        let side = axis.any_orthogonal_vector().normalize();
        let (sin, cos) = (TAU * turn).sin_cos();
        self.site_at(height.min(1.0), side * cos + axis.normalize().cross(side) * sin)
    }

    /// From the first end to the second.
    fn axis(&self) -> DVec3 {
        difference(self.ends[1], self.ends[0])
    }

    /// Returns by how much the radius grows from the first end to the second.
    fn widening(&self) -> f64 {
        f64::from(self.radii[1]) - f64::from(self.radii[0])
    }

    /// The square of the length of the side from rim to rim.
    fn slant_squared(&self) -> f64 {
        self.axis().length_squared() + self.widening().powi(2)
    }

    fn precise_area(&self) -> f64 {
        PI * (f64::from(self.radii[0]) + f64::from(self.radii[1])) * self.slant_squared().sqrt()
    }

    /// Returns the extent of a circle of radius one around the axis along each coordinate: √(1 −
    /// aᵢ²), from the other two so that it does not cancel.
    fn rim(&self) -> DVec3 {
        let axis = self.axis();
        let DVec3 { x, y, z } = axis * axis;
        let square = DVec3::new(y + z, z + x, x + y);
        DVec3::new(square.x.sqrt(), square.y.sqrt(), square.z.sqrt()) / axis.length()
    }

    /// The site nearest to a point given relative to the first end.
    fn site_near(&self, near: DVec3) -> SurfaceSite {
        let axis = self.axis();
        let side = self.across(near);
        // In the half plane of axis and side the surface is a line.
        let beyond = near.dot(side) - f64::from(self.radii[0]);
        let along = near.dot(axis) + beyond * self.widening();
        self.site_at((along / self.slant_squared()).clamp(0.0, 1.0), side)
    }

    /// The unit vector across the axis on the side of a point.
    ///
    /// Twice made perpendicular: what is left of the axis in the first result
    /// is a rounding of the length, and is turned into one of the radius.
    fn across(&self, point: DVec3) -> DVec3 {
        let axis = self.axis().normalize();
        let perpendicular = |v: DVec3| (v - axis * v.dot(axis)).normalize_or_zero();
        let side = perpendicular(perpendicular(point));
        if side == DVec3::ZERO { perpendicular(axis.any_orthogonal_vector()) } else { side }
    }

    /// The site at a part of the way from the first end to the second, on a
    /// side given by a unit vector across the axis.
    fn site_at(&self, height: f64, side: DVec3) -> SurfaceSite {
        let (axis, slant) = (self.axis(), self.slant_squared().sqrt());
        let radius = f64::from(self.radii[0]) + height * self.widening();
        let position = self.ends[0].as_dvec3() + (height * axis + radius * side);
        let length = axis.length();
        let outward = side * (length / slant) - axis * (self.widening() / (length * slant));
        let widest = f64::from(self.radii[0].max(self.radii[1]));
        let extent = axis.abs() + self.rim() * (2.0 * widest);
        let normal = self.facing.turn(outward.as_vec3());
        let site = SurfaceSite::new(position.as_vec3(), normal, extent.as_vec3());
        site.with_error(bend(position, radius))
    }
}

#[cfg(test)]
mod tests;
