//! Parallelograms.

use super::{ShapeHit, Sides, all_finite, sound_area};
use crate::precise::unit;
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};

/// A parallelogram: `corner + u · edge_u + v · edge_v` with u, v in [0, 1]. The
/// front normal is along `edge_u × edge_v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    corner: Vec3,
    normal: Vec3,
    /// Vectors in the plane whose dot products with a point relative to the
    /// corner are its u and v.
    dual_u: Vec3,
    dual_v: Vec3,
    edge_u: Vec3,
    edge_v: Vec3,
    area: f32,
}

impl Quad {
    /// The parallelogram at `corner` with these edges.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::NoArea`] when the edges are parallel.
    pub fn new(corner: Vec3, edge_u: Vec3, edge_v: Vec3) -> Result<Self, Error> {
        let opposite = corner + edge_u + edge_v;
        all_finite(&[corner, edge_u, edge_v, opposite])?;
        let (u, v) = (edge_u.as_dvec3(), edge_v.as_dvec3());
        let across = u.cross(v);
        let square = across.length_squared();
        let area = sound_area(square.sqrt())?;
        let normal = unit(across).ok_or(Error::NoArea)?;
        let dual_u = (v.cross(across) * (1.0 / square)).as_vec3();
        let dual_v = (across.cross(u) * (1.0 / square)).as_vec3();
        Ok(Self { corner, normal, dual_u, dual_v, edge_u, edge_v, area })
    }

    /// The corner where u and v are zero.
    pub fn corner(&self) -> Vec3 {
        self.corner
    }

    /// The two edges that leave the corner: the derivatives of a point of the
    /// surface with respect to its u and v, in metres.
    pub fn edges(&self) -> [Vec3; 2] {
        [self.edge_u, self.edge_v]
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let (a, b) = (self.corner, self.corner + self.edge_u);
        let corners = Aabb::around([a, b, a + self.edge_v, b + self.edge_v]);
        // Corners are rounded sums.
        corners.grown(corners.min.abs().max(corners.max.abs()) * f32::EPSILON)
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        self.area
    }

    /// Where a ray meets it, with the coordinates along its edges.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let slope = ray.direction.dot(self.normal);
        let from_corner = ray.origin - self.corner;
        let t = -from_corner.dot(self.normal) / slope;
        if !(ray.contains(t) && sides.admit(slope)) {
            return None;
        }
        let point = from_corner + t * ray.direction;
        let (u, v) = (point.dot(self.dual_u), point.dot(self.dual_v));
        let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
        inside.then_some(ShapeHit { t, u, v })
    }

    /// The site at coordinates `u`, `v`.
    pub(crate) fn site(&self, u: f32, v: f32) -> SurfaceSite {
        let position = self.corner + (u * self.edge_u + v * self.edge_v);
        SurfaceSite::new(position, self.normal, self.edge_u.abs() + self.edge_v.abs())
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        self.site(u.x, u.y)
    }
}
