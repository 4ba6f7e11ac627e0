//! Triangles.

use super::{ShapeHit, Sides, all_finite, sound_area};
use crate::precise::{difference, unit};
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
        let doubled = difference(b, a).cross(difference(c, a));
        sound_area(0.5 * doubled.length())?;
        let normal = unit(doubled).ok_or(Error::NoArea)?;
        Ok(Self { a, b, c, normal })
    }

    /// The three corners.
    pub fn corners(&self) -> [Vec3; 3] {
        [self.a, self.b, self.c]
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.corners())
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        let doubled = difference(self.b, self.a).cross(difference(self.c, self.a));
        (0.5 * doubled.length()) as f32
    }

    /// Where a ray meets it, with the barycentric coordinates of the second and
    /// the third corner.
    ///
    /// Watertight (Woop, Benthin and Wald, *Watertight Ray/Triangle
    /// Intersection*, JCGT 2013): the corners are sheared so that the ray
    /// becomes an axis; what is left is a plane figure in which a corner has
    /// the same place for all its triangles. Products are rounded before they
    /// are subtracted, so the sign of an edge function is right or zero, and
    /// zero counts as inside.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let shear = Shear::along(ray.direction);
        let (a, b, c) = (self.a - ray.origin, self.b - ray.origin, self.c - ray.origin);
        let (a_flat, b_flat, c_flat) = (shear.apply(a), shear.apply(b), shear.apply(c));
        let (of_a, of_b, of_c) =
            (b_flat.perp_dot(c_flat), c_flat.perp_dot(a_flat), a_flat.perp_dot(b_flat));
        let least = of_a.min(of_b).min(of_c);
        let most = of_a.max(of_b).max(of_c);
        let sum = of_a + of_b + of_c;
        // NaN passes neither comparison with zero.
        if least < 0.0 && most > 0.0 || sum == 0.0 || sum.is_nan() {
            return None;
        }
        let slope = ray.direction.dot(self.normal);
        if slope == 0.0 || !sides.admit(slope) {
            return None;
        }
        // The plane gives t most precisely, except to a ray within it; no
        // point of the triangle is nearer or farther than its corners.
        let (ta, tb, tc) = (shear.depth(a), shear.depth(b), shear.depth(c));
        let t = (a.dot(self.normal) / slope).max(ta.min(tb).min(tc)).min(ta.max(tb).max(tc));
        ray.contains(t).then(|| ShapeHit { t, u: of_b / sum, v: of_c / sum })
    }

    /// The site at barycentric coordinates `u`, `v`.
    pub(crate) fn site(&self, u: f32, v: f32) -> SurfaceSite {
        let (ab, ac) = (self.b - self.a, self.c - self.a);
        SurfaceSite::new(self.a + (u * ab + v * ac), self.normal, ab.abs() + ac.abs())
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        let barycentric = warp::uniform_triangle(u);
        self.site(barycentric.x, barycentric.y)
    }
}

/// The map that leaves out one coordinate, the one along which the ray is
/// longest, and shifts the others so that the ray's direction becomes zero.
struct Shear {
    axis: usize,
    slope: Vec2,
    reciprocal: f32,
}

impl Shear {
    #[inline]
    fn along(direction: Vec3) -> Self {
        let size = direction.abs();
        let axis = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (flat, depth) = split(direction, axis);
        let reciprocal = 1.0 / depth;
        Self { axis, slope: flat * reciprocal, reciprocal }
    }

    #[inline]
    fn apply(&self, v: Vec3) -> Vec2 {
        let (flat, depth) = split(v, self.axis);
        flat - self.slope * depth
    }

    /// t of the point of the ray beside `v`.
    #[inline]
    fn depth(&self, v: Vec3) -> f32 {
        split(v, self.axis).1 * self.reciprocal
    }
}

/// The two other coordinates, and the one along `axis`.
#[inline]
fn split(v: Vec3, axis: usize) -> (Vec2, f32) {
    match axis {
        0 => (Vec2::new(v.y, v.z), v.x),
        1 => (Vec2::new(v.z, v.x), v.y),
        _ => (Vec2::new(v.x, v.y), v.z),
    }
}

#[cfg(test)]
mod tests;
