//! Surfaces in the planes of coordinates, where the bound on error per axis vanishes.

use super::*;
use crate::bvh::{Options, Precision};
use crate::{Bvh, Mesh, Vec2};

/// The distances from the plane through the origin: in it, next to it, and where people put floors.
const HEIGHTS: [f32; 9] = [0.0, 1e-40, 1e-30, 1e-20, -1e-12, 1e-6, 0.125, -1.0, 1e3];

/// A point of the plane across an axis at this height.
fn place(axis: usize, height: f32, at: Vec2) -> Vec3 {
    let mut point = Vec3::splat(height);
    point[(axis + 1) % 3] = at.x;
    point[(axis + 2) % 3] = at.y;
    point
}

fn random_place(random: &mut Random) -> Vec2 {
    random.point().truncate() * random.magnitude(1e3)
}

/// A flat shape in that plane.
fn flat(kind: u32, axis: usize, height: f32, random: &mut Random) -> Option<Primitive> {
    let [a, b, c] = [(); 3].map(|()| place(axis, height, random_place(random)));
    let normal = place(axis, 0.0, Vec2::ZERO) + Vec3::AXES[axis];
    match kind % 3 {
        0 => Triangle::new(a, b, c).ok().map(Primitive::Triangle),
        1 => Quad::new(a, b - a, c - a).ok().map(Primitive::Quad),
        _ => Disk::new(a, normal, a.distance(b)).ok().map(Primitive::Disk),
    }
}

fn every_plane(mut test: impl FnMut(usize, f32)) {
    for axis in 0..3 {
        for height in HEIGHTS {
            test(axis, height);
        }
    }
}

#[test]
fn rays_leave_flat_shapes() {
    let mut random = Random::new(11);
    every_plane(|axis, height| {
        for kind in 0..6000 {
            let Some(shape) = flat(kind, axis, height, &mut random) else { continue };
            let site = shape.sample_area(random.square());
            for side in [1.0, -1.0] {
                let out = leaving(side * site.normal, &mut random);
                let ray = Ray::new(site.ray_origin(out), out);
                assert_eq!(shape.intersect(&ray, Sides::Both), None, "{shape:?} {site:?} {out}");
            }
        }
    });
}

#[test]
fn segments_between_flat_shapes_meet_neither() {
    let mut random = Random::new(12);
    every_plane(|axis, height| {
        for kind in 0..3000 {
            let Some(shape) = flat(kind, axis, height, &mut random) else { continue };
            let other = some_shape(kind, &mut random).sample_area(random.square());
            let site = shape.sample_area(random.square());
            for segment in [site.segment_to(&other), other.segment_to(&site)] {
                assert_eq!(shape.intersect(&segment, Sides::Both), None, "{shape:?} {site:?}");
            }
            let point = other.position;
            for segment in [site.segment_to_point(point), site.segment_from_point(point)] {
                assert_eq!(shape.intersect(&segment, Sides::Both), None, "{shape:?} {site:?}");
            }
        }
    });
}

/// A floor of triangles whose sizes differ by a thousand.
fn floor(axis: usize, height: f32, random: &mut Random) -> Mesh {
    let steps: Vec<f32> = (0..9).map(|_| random.magnitude(1e3)).collect();
    let line = |mut at: f32| {
        steps.iter().map(move |step| {
            at += step;
            at
        })
    };
    let places: Vec<Vec2> =
        line(-1e3).flat_map(|x| line(-2e3).map(move |y| Vec2::new(x, y))).collect();
    let positions = places.iter().map(|&at| place(axis, height, at)).collect();
    let cell = |i: u32| [[i, i + 1, i + 9], [i + 10, i + 9, i + 1]];
    let cells = (0..72).filter(|i| i % 9 != 8).flat_map(cell).collect();
    Mesh::new(positions, cells).unwrap()
}

/// Rays that leave a triangle, one after the other and in batches, whole packets among
/// them: nothing is met, neither the triangle nor its neighbours.
#[test]
fn rays_leave_meshes_in_every_kernel() {
    let mut random = Random::new(13);
    every_plane(|axis, height| {
        let mesh = floor(axis, height, &mut random);
        let options = Options { precision: Precision::Watertight, ..Options::default() };
        let bvh = Bvh::build_with(&mesh, options).unwrap();
        let mut rays = Vec::new();
        for index in 0..mesh.triangle_count() {
            let Some(triangle) = mesh.triangle(index) else { continue };
            let site = Primitive::Triangle(triangle).sample_area(random.square());
            for side in [1.0, -1.0] {
                let out = leaving(side * site.normal, &mut random);
                let beside = out.cross(site.normal) * 1e-3;
                let packet = (0..8_u8).map(|i| out + f32::from(i) * beside);
                rays.extend(packet.map(|out| Ray::new(site.ray_origin(out), out)));
            }
        }
        let (mut nearest, mut any) = (vec![None; rays.len()], vec![false; rays.len()]);
        bvh.nearest_each(&rays, &mut nearest);
        bvh.any_hit_each(&rays, &mut any);
        for (index, ray) in rays.iter().enumerate() {
            assert_eq!((bvh.nearest(ray), nearest[index]), (None, None), "{height} {ray:?}");
            assert!(!bvh.any_hit(ray) && !any[index], "{height} {ray:?}");
        }
    });
}
