//! Spheres, a quad, a triangle and a shape of our own in one tree.
//!
//!     cargo run --example mixed
#![allow(clippy::print_stdout, reason = "a program speaks to its user")]

use std::error::Error;
use traylib_geometry::{Aabb, Bvh, Facing, Quad, Ray, Shape, ShapeHit, Sphere, Triangle, Vec3};

/// A ball, stretched along the axes: what the crate does not have.
struct Ellipsoid {
    centre: Vec3,
    radii: Vec3,
}

impl Shape for Ellipsoid {
    fn bounds(&self) -> Aabb {
        // A little more than the radii, since intersections round.
        let reach = self.radii * (1.0 + 8.0 * f32::EPSILON);
        Aabb { min: self.centre - reach, max: self.centre + reach }
    }

    /// The unit sphere, met by a ray that is squeezed as the ellipsoid would be.
    fn intersect(&self, ray: &Ray) -> Option<ShapeHit> {
        let (from, to) = ((ray.origin - self.centre) / self.radii, ray.direction / self.radii);
        let (a, half_b, c) = (to.dot(to), from.dot(to), from.dot(from) - 1.0);
        let root = (half_b * half_b - a * c).sqrt();
        // No real root is not a number, which no comparison is true of.
        let t = [(-half_b - root) / a, (-half_b + root) / a]
            .into_iter()
            .find(|&t| 0.0 < t && t < ray.t_max)?;
        Some(ShapeHit { t, u: 0.0, v: 0.0 })
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let names = ["floor", "red ball", "blue ball", "sail", "egg"];
    let shapes: Vec<Box<dyn Shape>> = vec![
        Box::new(Quad::new(Vec3::new(-4.0, 0.0, -4.0), 8.0 * Vec3::Z, 8.0 * Vec3::X)?),
        Box::new(Sphere::new(Vec3::new(-2.0, 1.0, 0.0), 1.0, Facing::Outward)?),
        Box::new(Sphere::new(Vec3::new(2.0, 0.5, 0.0), 0.5, Facing::Outward)?),
        Box::new(Triangle::new(Vec3::Y, Vec3::new(1.0, 1.0, -1.0), Vec3::new(0.5, 3.0, -0.5))?),
        Box::new(Ellipsoid { centre: 0.7 * Vec3::Y, radii: Vec3::new(0.4, 0.7, 0.4) }),
    ];
    let bvh = Bvh::of_shapes(shapes)?;

    let eye = Vec3::new(0.0, 1.5, 6.0);
    for x in [-2.0, -1.0, 0.0, 0.5, 2.0, 9.0] {
        // The sail hangs higher than all else.
        let target = Vec3::new(x, if x == 0.5 { 1.7 } else { 0.5 }, 0.0);
        let ray = Ray::new(eye, target - eye);
        match bvh.nearest(&ray) {
            Some(hit) => println!("{x:4}: {} at {}", names[hit.primitive as usize], ray.at(hit.t)),
            None => println!("{x:4}: nothing"),
        }
    }
    Ok(())
}
