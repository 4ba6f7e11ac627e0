//! Triangles.

use super::{ShapeHit, SidedTriangle, Sides, all_finite, sound_area};
use crate::precise::unit;
use crate::watertight::{self, pick};
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};
use traylib_math::warp;

/// A triangle; from the front its corners go counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    a: Vec3,
    b: Vec3,
    c: Vec3,
    normal: Vec3,
}

impl Triangle {
    /// The triangle with these corners.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::NoArea`] when the corners lie on a line.
    pub fn new(a: Vec3, b: Vec3, c: Vec3) -> Result<Self, Error> {
        all_finite(&[a, b, c])?;
        sound_area(0.5 * watertight::normal([a, b, c]).length())?;
        let normal = Self::normal_of([a, b, c]).ok_or(Error::NoArea)?;
        Ok(Self { a, b, c, normal })
    }

    /// The three corners.
    pub fn corners(&self) -> [Vec3; 3] {
        [self.a, self.b, self.c]
    }

    /// Returns the triangle for a tree, with sides.
    pub(crate) fn sided(&self, sides: Sides) -> SidedTriangle {
        SidedTriangle { corners: self.corners(), sides }
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.corners())
    }

    /// Tells whether [`new`](Self::new) would take these corners, which must be finite.
    pub(crate) fn has_area(corners: [Vec3; 3]) -> bool {
        sound_area(0.5 * watertight::normal(corners).length()).is_ok()
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        Self::area_of(self.corners())
    }

    /// The area of a triangle with these corners.
    pub(crate) fn area_of(corners: [Vec3; 3]) -> f32 {
        (0.5 * watertight::normal(corners).length()) as f32
    }

    /// Returns the hit of a ray with it, with the barycentric coordinates of the second and the
    /// third corner; without gaps where triangles share their corners.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        if !sides.admit(ray.direction.dot(self.normal)) {
            return None;
        }
        let axes = watertight::axes(&ray.direction);
        let corners = self.corners().map(|corner| pick(&corner, axes));
        // Asked last: trees have asked already, and few triangles are met.
        watertight::meet(ray, axes, ray.t_max, corners).filter(|_| ray.is_traceable())
    }

    /// Tells whether barycentric coordinates lie on an edge.
    #[inline]
    pub fn is_on_edge(u: f32, v: f32) -> bool {
        u <= 0.0 || v <= 0.0 || u + v >= 1.0
    }

    /// The site at barycentric coordinates `u`, `v`.
    pub(crate) fn site(&self, u: f32, v: f32) -> SurfaceSite {
        Self::site_between(self.corners(), self.normal, u, v)
    }

    /// Measures the triangle with these corners and this unit normal.
    #[inline]
    pub(crate) fn site_between(corners: [Vec3; 3], normal: Vec3, u: f32, v: f32) -> SurfaceSite {
        let [a, b, c] = corners;
        let (ab, ac) = (b - a, c - a);
        SurfaceSite::flat(a + (u * ab + v * ac), normal, ab.abs() + ac.abs())
    }

    /// The unit normal of the front of a triangle with these corners; `None` without area.
    #[inline]
    pub(crate) fn normal_of(corners: [Vec3; 3]) -> Option<Vec3> {
        unit(watertight::normal(corners))
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        let barycentric = warp::uniform_triangle(u);
        self.site(barycentric.x, barycentric.y)
    }
}

#[cfg(test)]
mod tests;
