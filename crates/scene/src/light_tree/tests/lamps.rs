//! Lamps of every kind.

use super::{point, sampler};
use crate::{Light, PointLight, SpotCone};
use traylib_geometry::{Cone, Disk, Facing, Primitive, Quad, Sphere, Triangle};
use traylib_math::{Rgb, Sampler, Vec3, warp};

const FACINGS: [Facing; 2] = [Facing::Outward, Facing::Inward];

/// Two directions and a size at a place.
struct Measures {
    at: Vec3,
    edges: [Vec3; 2],
    size: f32,
}

impl Measures {
    /// All forms of the first kind of shape, or of the one after the last; none after
    /// the last of all. A new kind has to find its place here.
    fn forms_after(&self, last: Option<&Primitive>) -> Vec<Primitive> {
        let &Self { at, edges: [u, v], size } = self;
        let (u, v) = (u * size, v * size);
        match last {
            None => vec![Primitive::Triangle(Triangle::new(at, at + u, at + v).unwrap())],
            Some(Primitive::Triangle(_)) => vec![Primitive::Quad(Quad::new(at, u, v).unwrap())],
            Some(Primitive::Quad(_)) => {
                let ball = |facing| Primitive::Sphere(Sphere::new(at, size, facing).unwrap());
                FACINGS.map(ball).to_vec()
            }
            Some(Primitive::Sphere(_)) => {
                let ring = |inner| Primitive::Disk(Disk::ring(at, u, inner, size).unwrap());
                [0.0, 0.75 * size].map(ring).to_vec()
            }
            Some(Primitive::Disk(_)) => {
                let cone = |radii, facing| Cone::new([at, at + v], radii, facing).unwrap();
                let radii = [[0.25, 0.25], [0.1, 0.125], [0.5, 0.0], [0.0, 1e-3], [8.0, 1.0]];
                let both = |radii: [f32; 2]| FACINGS.map(|f| cone(radii.map(|r| r * size), f));
                radii.into_iter().flat_map(both).map(Primitive::Cone).collect()
            }
            Some(Primitive::Cone(_)) => Vec::new(),
        }
    }
}

/// Shapes of every kind and form about a place in a room of 20 m, of a size up to a
/// metre: all lengths times `scale`, a power of two.
pub(super) fn shapes(sampler: &mut Sampler, scale: f32) -> Vec<Primitive> {
    let at = point(sampler, 10.0) * scale;
    let edges = [(); 2].map(|()| warp::uniform_sphere(sampler.next_2d()));
    let measures = Measures { at, edges, size: sampler.next_1d() * scale };
    let mut all = Vec::new();
    loop {
        let forms = measures.forms_after(all.last());
        if forms.is_empty() {
            return all;
        }
        all.extend(forms);
    }
}

/// The lamp of this number among all shapes, a point and a spot light, over and over;
/// lengths times `scale` and radiances the same.
pub(super) fn lamp(sampler: &mut Sampler, number: usize, scale: f32) -> Light {
    let shapes = shapes(sampler, scale);
    let bright = Rgb::splat(10.0 * sampler.next_1d() + 0.01);
    let kind = number % (shapes.len() + 2);
    if let Some(&primitive) = shapes.get(kind) {
        return Light::Area { primitive, radiance: bright };
    }
    let position = point(sampler, 10.0) * scale;
    let cone = (kind == shapes.len()).then(|| {
        let [a, b] = sampler.next_2d().to_array().map(|x| 2.0 * x - 1.0);
        let axis = warp::uniform_sphere(sampler.next_2d());
        SpotCone::new(axis, a.max(b), a.min(b)).unwrap()
    });
    Light::Point(PointLight { position, intensity: bright * (scale * scale), cone })
}

/// The first `count` of [`lamp`].
pub(super) fn lamps(count: usize, seed: u64, scale: f32) -> Vec<Light> {
    let mut sampler = sampler(seed);
    (0..count).map(|number| lamp(&mut sampler, number, scale)).collect()
}
