//! The closed set of shapes that scenes are made of.

mod form;
mod touch;

pub use form::{Form, Outline};

use crate::shape::{SphericalRectangle, SphericalTriangle, even_pdf, shape_from_both_sides};
use crate::{
    Aabb, Cone, Disk, Error, Facing, Hit, Normals, Quad, Ray, Shape, ShapeHit, ShapeKind, Sides,
    Sphere, SurfaceSite, Triangle, Vec2, Vec3,
};
use traylib_math::{AreaPdf, warp};

/// One of the shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A triangle.
    Triangle(Triangle),
    /// A parallelogram.
    Quad(Quad),
    /// A sphere.
    Sphere(Sphere),
    /// A flat disk or ring.
    Disk(Disk),
    /// A truncated cone or a cylinder, without its ends.
    Cone(Cone),
}

impl Primitive {
    /// A box that holds it, rounding included.
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Triangle(triangle) => triangle.bounds(),
            Self::Quad(quad) => quad.bounds(),
            Self::Sphere(sphere) => sphere.bounds(),
            Self::Disk(disk) => disk.bounds(),
            Self::Cone(cone) => cone.bounds(),
        }
    }

    /// The first hit with 0 < t < `ray.t_max` on an admitted side.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        match self {
            Self::Triangle(triangle) => triangle.intersect(ray, sides),
            Self::Quad(quad) => quad.intersect(ray, sides),
            Self::Sphere(sphere) => sphere.intersect(ray, sides),
            Self::Disk(disk) => disk.intersect(ray, sides),
            Self::Cone(cone) => cone.intersect(ray, sides),
        }
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        match self {
            Self::Triangle(triangle) => triangle.area(),
            Self::Quad(quad) => quad.area(),
            Self::Sphere(sphere) => sphere.area(),
            Self::Disk(disk) => disk.area(),
            Self::Cone(cone) => cone.area(),
        }
    }

    /// The directions that its front faces.
    pub fn normals(&self) -> Normals {
        match self {
            Self::Triangle(triangle) => Normals::one(triangle.normal()),
            Self::Quad(quad) => Normals::one(quad.normal()),
            Self::Sphere(_) => Normals::ALL,
            Self::Disk(disk) => Normals::one(disk.normal()),
            Self::Cone(cone) => cone.normals(),
        }
    }

    /// The area, in square metres, of the largest shadow that its front can cast on
    /// a plane: ∫ max(0, N·ω) dA for the direction ω in which that is most. On a cone
    /// up to 2 % less than that, exact on all else.
    pub fn largest_shadow(&self) -> f32 {
        match self {
            Self::Triangle(_) | Self::Quad(_) | Self::Disk(_) => self.area(),
            // A convex body's mean shadow is a quarter of its surface, and all
            // shadows of a ball are alike.
            Self::Sphere(sphere) => 0.25 * sphere.area(),
            Self::Cone(cone) => cone.largest_shadow(),
        }
    }

    /// The point of the surface that a ray met.
    ///
    /// It is computed from the surface, never as origin + t·direction alone,
    /// whose error grows with the length of the ray: from the coordinates of
    /// the hit on triangles and quads, by projection on spheres, disks and
    /// cones.
    pub fn site(&self, ray: &Ray, hit: &Hit) -> SurfaceSite {
        match self {
            Self::Triangle(triangle) => triangle.site(hit.u, hit.v),
            Self::Quad(quad) => quad.site(hit.u, hit.v),
            Self::Sphere(sphere) => sphere.site(ray, hit.t),
            Self::Disk(disk) => disk.site(ray, hit.t),
            Self::Cone(cone) => cone.site(ray, hit.t),
        }
    }

    /// A point uniform on the surface: its density is 1/[`area`](Self::area).
    pub fn sample_area(&self, u: Vec2) -> SurfaceSite {
        match self {
            Self::Triangle(triangle) => triangle.sample_area(u),
            Self::Quad(quad) => quad.sample_area(u),
            Self::Sphere(sphere) => sphere.sample_area(u),
            Self::Disk(disk) => disk.sample_area(u),
            Self::Cone(cone) => cone.sample_area(u),
        }
    }

    /// The surface coordinates of the point that [`sample_area`](Self::sample_area)
    /// makes of `u`, as a [`Hit`] has them: zero on shapes without any.
    pub fn sample_coordinates(&self, u: Vec2) -> Vec2 {
        match self {
            Self::Triangle(_) => warp::uniform_triangle(u),
            Self::Quad(_) => u,
            Self::Sphere(_) | Self::Disk(_) | Self::Cone(_) => Vec2::ZERO,
        }
    }

    /// Returns the kind of shape that it is to a tree, with these sides.
    pub fn kind(&self, sides: Sides) -> ShapeKind {
        match *self {
            Self::Triangle(triangle) => ShapeKind::Triangle(triangle.sided(sides)),
            Self::Quad(quad) => ShapeKind::Quad(quad, sides),
            Self::Sphere(sphere) => ShapeKind::Sphere(sphere, sides),
            Self::Disk(disk) => ShapeKind::Disk(disk, sides),
            Self::Cone(_) => ShapeKind::Other,
        }
    }

    /// Tells whether surface coordinates lie on an edge, where other shapes may begin, up to
    /// rounding. Round shapes say no: none of theirs lies across another.
    #[inline]
    pub fn is_on_edge(&self, u: f32, v: f32) -> bool {
        match self {
            Self::Triangle(_) => Triangle::is_on_edge(u, v),
            Self::Quad(_) => u <= 0.0 || v <= 0.0 || u >= 1.0 || v >= 1.0,
            Self::Sphere(_) | Self::Disk(_) | Self::Cone(_) => false,
        }
    }

    /// Returns the derivatives of the place by each surface coordinate, along which pictures lie,
    /// in metres a unit; `None` where no picture can lie.
    pub fn tangents(&self) -> Option<[Vec3; 2]> {
        match self {
            Self::Quad(quad) => Some(quad.edges()),
            Self::Triangle(_) | Self::Sphere(_) | Self::Disk(_) | Self::Cone(_) => None,
        }
    }

    /// A site with the normal and the error of a point on the surface, which is `point` on
    /// what is round, and any on what is flat.
    fn site_near(&self, point: Vec3) -> SurfaceSite {
        match self {
            Self::Triangle(triangle) => triangle.site(1.0 / 3.0, 1.0 / 3.0),
            Self::Quad(quad) => quad.site(0.5, 0.5),
            Self::Sphere(sphere) => sphere.site(&Ray::new(point, Vec3::ZERO), 0.0),
            Self::Disk(disk) => disk.site(&Ray::new(point, Vec3::ZERO), 0.0),
            Self::Cone(cone) => cone.site(&Ray::new(point, Vec3::ZERO), 0.0),
        }
    }

    /// The shape moved to its front: what is flat by `offset`, which is `height` along its
    /// normal, what is round by making it wider or narrower.
    fn lifted_by(&self, height: f32, offset: Vec3) -> Result<Self, Error> {
        match self {
            Self::Triangle(triangle) => {
                let [a, b, c] = triangle.corners().map(|corner| corner + offset);
                Triangle::new(a, b, c).map(Self::Triangle)
            }
            Self::Quad(quad) => {
                let [u, v] = quad.edges();
                Quad::new(quad.corner() + offset, u, v).map(Self::Quad)
            }
            Self::Disk(disk) => {
                let [inner, outer] = [disk.inner_radius(), disk.radius()];
                Disk::ring(disk.centre() + offset, disk.normal(), inner, outer).map(Self::Disk)
            }
            Self::Sphere(sphere) => {
                let (centre, facing) = (sphere.centre(), sphere.facing());
                Sphere::new(centre, sphere.radius() + facing.turn(height), facing).map(Self::Sphere)
            }
            Self::Cone(cone) => {
                let (ends, facing) = (cone.ends(), cone.facing());
                let radii = cone.radii().map(|radius| (radius + facing.turn(height)).max(0.0));
                Cone::new(ends, radii, facing).map(Self::Cone)
            }
        }
    }

    /// Returns whether it is flat, a ball or bent otherwise. Images depend on that, those that it
    /// shows as a mirror and those that mirrors show of it.
    pub fn form(&self) -> Form {
        let flat = |normal, outline| Form::Flat { normal, outline };
        match self {
            Self::Triangle(triangle) => {
                flat(triangle.normal(), Outline::Triangle(triangle.corners()))
            }
            Self::Quad(quad) => {
                let (corner, edges) = (quad.corner(), quad.edges());
                flat(quad.normal(), Outline::Parallelogram { corner, edges })
            }
            Self::Sphere(sphere) => Form::Ball(*sphere),
            Self::Disk(disk) => {
                let (centre, radius) = (disk.centre(), disk.radius());
                flat(disk.normal(), Outline::Circle { centre, radius })
            }
            Self::Cone(cone) => Form::Bent(cone.bounds()),
        }
    }

    /// Tells whether two points of the front can see one another's front: on the inside of round
    /// shapes.
    pub fn faces_itself(&self) -> bool {
        match self {
            Self::Triangle(_) | Self::Quad(_) | Self::Disk(_) => false,
            Self::Sphere(sphere) => sphere.facing() == Facing::Inward,
            Self::Cone(cone) => cone.facing() == Facing::Inward,
        }
    }

    /// A point to light `from` with, and its density per square metre.
    ///
    /// A sphere that faces outward, seen from outside, is sampled uniformly in
    /// the cone of directions it fills; a rectangle or a triangle uniformly in solid
    /// angle if `from` is in front of it and no further away than it is wide; all else
    /// uniformly by area. At the rim of a sphere, and next to what is flat, rounding can
    /// turn a point away, which then has density zero and sends no light.
    pub fn sample_toward(&self, from: Vec3, u: Vec2) -> (SurfaceSite, AreaPdf) {
        let by_solid_angle = match self {
            Self::Triangle(triangle) => SphericalTriangle::sample_site(triangle, from, u),
            Self::Quad(quad) => SphericalRectangle::sample_site(quad, from, u),
            Self::Sphere(sphere) => sphere.sample_cone(from, u),
            Self::Disk(_) | Self::Cone(_) => None,
        };
        by_solid_angle.unwrap_or_else(|| (self.sample_area(u), self.area_pdf()))
    }

    /// The surface coordinates of the point that [`sample_toward`](Self::sample_toward)
    /// makes of `u`, as a [`Hit`] has them: zero on shapes without any.
    pub fn coordinates_toward(&self, from: Vec3, u: Vec2) -> Vec2 {
        let by_solid_angle = match self {
            Self::Triangle(triangle) => {
                SphericalTriangle::seen(triangle, from).map(|seen| seen.sample(u))
            }
            Self::Quad(quad) => SphericalRectangle::seen(quad, from).map(|seen| seen.sample(u)),
            Self::Sphere(_) | Self::Disk(_) | Self::Cone(_) => None,
        };
        by_solid_angle.unwrap_or_else(|| self.sample_coordinates(u))
    }

    /// The density per square metre with which
    /// [`sample_toward`](Self::sample_toward)`(from, ·)` gives the point of
    /// this surface with this position and front normal.
    pub fn pdf_toward(&self, from: Vec3, site_position: Vec3, site_normal: Vec3) -> AreaPdf {
        let even = |solid_angle| even_pdf(solid_angle, from, site_position, site_normal);
        let by_solid_angle = match self {
            Self::Triangle(triangle) => {
                SphericalTriangle::seen(triangle, from).map(|seen| even(seen.solid_angle()))
            }
            Self::Quad(quad) => {
                SphericalRectangle::seen(quad, from).map(|seen| even(seen.solid_angle()))
            }
            Self::Sphere(sphere) => sphere.pdf_cone(from, site_position, site_normal),
            Self::Disk(_) | Self::Cone(_) => None,
        };
        by_solid_angle.unwrap_or_else(|| self.area_pdf())
    }

    fn area_pdf(&self) -> AreaPdf {
        AreaPdf(1.0 / self.area())
    }
}

/// A primitive with the sides it can be met from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidedPrimitive {
    /// The primitive.
    pub primitive: Primitive,
    /// The sides on which rays may meet it.
    pub sides: Sides,
}

shape_from_both_sides!(Primitive: |primitive, sides| primitive.kind(sides));

impl Shape for SidedPrimitive {
    fn bounds(&self) -> Aabb {
        self.primitive.bounds()
    }

    #[inline]
    fn intersect(&self, ray: &Ray) -> Option<ShapeHit> {
        self.primitive.intersect(ray, self.sides)
    }

    fn kind(&self) -> ShapeKind {
        self.primitive.kind(self.sides)
    }
}

#[cfg(test)]
mod tests;
