//! A closed surface to look for gaps in.

use super::surfaces::Surfaces;
use std::f32::consts::{PI, TAU};
use traylib_geometry::{Error, Mesh, Ray, Vec3};
use traylib_math::Sampler;

/// A point inside of [`lumpy_ball`] that sees all of its surface.
pub(crate) const INSIDE: Vec3 = Vec3::new(0.3, 0.2, 0.1);

/// A ball with lumps around [`INSIDE`]; neighbouring triangles share corners, so
/// that no ray gets out.
pub(crate) fn lumpy_ball() -> Result<Mesh, Error> {
    let mut surfaces = Surfaces::default();
    surfaces.ring([96, 48], |u, v| {
        let (phi, theta) = (TAU * u, PI * v);
        // Poles are one point each: the sine of the rounded pi is not zero.
        let flat = if v == 0.0 || v == 1.0 { 0.0 } else { theta.sin() };
        let radius = 1.0 + 0.1 * flat * (7.0 * phi).sin() * (5.0 * theta).cos();
        INSIDE + radius * Vec3::new(flat * phi.cos(), theta.cos(), flat * phi.sin())
    });
    surfaces.mesh()
}

/// Rays from inside of `mesh` to corners of it and to points of its edges.
pub(crate) fn rays_at_seams(mesh: &Mesh, count: usize) -> Vec<Ray> {
    let mut sampler = Sampler::numbered(7, 0);
    let triangles = mesh.triangles();
    let mut at_one = |_| {
        let triangle = triangles[(sampler.next_1d() * triangles.len() as f32) as usize];
        let [a, b, _] = triangle.map(|i| mesh.positions()[i as usize]);
        // A quarter of them at a corner.
        let along = (sampler.next_1d() * 4.0 / 3.0 - 1.0 / 3.0).max(0.0);
        let jitter = Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d());
        let origin = INSIDE + 0.2 * jitter;
        Ray::new(origin, a.lerp(b, along) - origin)
    };
    (0..count).map(&mut at_one).collect()
}
