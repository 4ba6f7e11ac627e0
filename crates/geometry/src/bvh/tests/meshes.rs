//! Trees over meshes find what asking each triangle finds.

use crate::bvh::*;
use crate::f32_filter::Shear;
use crate::testing::{Random, icosphere};
use crate::{Mesh, Sides};

fn brute_force(mesh: &Mesh, ray: &Ray) -> Option<Hit> {
    let hits = (0..mesh.triangle_count()).filter_map(|i| {
        let hit = mesh.triangle(i)?.intersect(ray, Sides::Both)?;
        Some(Hit { t: hit.t, primitive: i as u32, u: hit.u, v: hit.v })
    });
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

fn soup(count: usize, random: &mut Random) -> Mesh {
    let positions: Vec<Vec3> = (0..count)
        .flat_map(|_| {
            let (place, size) = (random.point(), 0.01 + random.number());
            [place, place + size * random.point(), place + size * random.point()]
        })
        .collect();
    let triangles = (0..count as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh::new(positions, triangles).unwrap()
}

#[test]
fn a_mesh_is_met_as_its_triangles_are() {
    let mut random = Random::new(21);
    for count in [0, 1, 2, 3, 4, 5, 9, 30, 300] {
        if cfg!(miri) && count > 30 {
            continue;
        }
        let mesh = soup(count, &mut random);
        for quality in [Quality::Fast, Quality::Balanced, Quality::Best] {
            let options = Options { quality, ..Options::default() };
            let bvh = Bvh::build_with(&mesh, options).unwrap();
            for _ in 0..if cfg!(miri) { 5 } else { 1000 } {
                let ray = Ray::new(random.point(), random.direction());
                assert_eq!(bvh.nearest(&ray), brute_force(&mesh, &ray), "{ray:?}");
            }
        }
    }
}

/// t of the fast form is a sum of three products over their sum.
#[test]
fn the_fast_form_finds_nearly_the_same() {
    let mut random = Random::new(22);
    let mesh = icosphere(if cfg!(miri) { 0 } else { 3 });
    let fast = Options { precision: Precision::Fast, ..Options::default() };
    let (exact, fast) = (Bvh::build(&mesh).unwrap(), Bvh::build_with(&mesh, fast).unwrap());
    for _ in 0..if cfg!(miri) { 10 } else { 20_000 } {
        let ray = Ray::new(0.5 * random.point(), random.direction());
        let (Some(a), Some(b)) = (exact.nearest(&ray), fast.nearest(&ray)) else {
            panic!("the ball is closed: {ray:?}")
        };
        assert!((a.t - b.t).abs() < 1e-5 * a.t, "{a:?} {b:?}");
    }
}

#[test]
fn all_hits_come_in_order() {
    let mesh = Mesh::new(
        (0..4_u8)
            .flat_map(|i| [0.0, 1.0, 2.0].map(|x| Vec3::new(x, x * x, f32::from(i % 3))))
            .collect(),
        (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
    )
    .unwrap();
    let bvh = Bvh::build(&mesh).unwrap();
    let ray = Ray { t_max: 2.5, ..Ray::new(Vec3::new(1.0, 1.5, -1.0), Vec3::Z) };
    let all: Vec<(f32, u32)> = bvh.all_hits(&ray).iter().map(|h| (h.t, h.primitive)).collect();
    assert_eq!(all, [(1.0, 0), (1.0, 3), (2.0, 1)]);
}

#[test]
fn triangles_without_area_are_never_hit() {
    let positions = vec![Vec3::ZERO, Vec3::X, 2.0 * Vec3::X, Vec3::Y];
    let mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 0, 1], [0, 1, 3]]).unwrap();
    let bvh = Bvh::build(&mesh).unwrap();
    let down = |x, y| bvh.nearest(&Ray::new(Vec3::new(x, y, 1.0), Vec3::NEG_Z));
    assert_eq!(down(0.25, 0.0).map(|h| h.primitive), Some(2));
    assert_eq!(down(1.5, 0.0), None);
    let flat = Mesh::new(vec![Vec3::ONE; 3], vec![[0, 1, 2]]).unwrap();
    let flat = Bvh::build(&flat).unwrap();
    assert!(flat.bounds().is_empty() && !flat.any_hit(&Ray::new(Vec3::ZERO, Vec3::ONE)));
}

/// Lists of hits may be longer or shorter than those of rays.
#[test]
fn batches_answer_each_ray() {
    let mesh = icosphere(if cfg!(miri) { 0 } else { 2 });
    let bvh = Bvh::build(&mesh).unwrap();
    let mut random = Random::new(23);
    let mut rays: Vec<Ray> =
        (0..21).map(|_| Ray::new(2.0 * random.point(), random.direction())).collect();
    rays[3].direction = Vec3::ZERO;
    rays[20].origin = Vec3::NAN;
    for count in [0, 1, 2, 3, 5, 8, 9, 21] {
        let mut hits = vec![bvh.nearest(&Ray::new(Vec3::ZERO, Vec3::X)); count];
        bvh.nearest_each(&rays[..count], &mut hits);
        assert!(hits.iter().zip(&rays).all(|(hit, ray)| *hit == bvh.nearest(ray)));
    }
}

/// Beyond a hit, triangles are left out that begin farther by these depths; so none may be
/// hit before them, also where signs are not certain and are computed in double precision.
#[test]
fn a_fast_hit_lies_between_the_depths_of_the_corners() {
    let corners = [[-4.0, -3.0, 0.0], [-4.0, 0.0, 3.0], [3.0, -3.0, 1.0]].map(Vec3::from);
    let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
    let fast = Options { precision: Precision::Fast, ..Options::default() };
    let bvh = Bvh::build_with(&mesh, fast).unwrap();
    for i in 0..100_u8 {
        let origin = Vec3::new(-4.0, -2.0, -6.5e13 - 1e10 * f32::from(i));
        let ray = Ray::new(origin, Vec3::new(0.0, 3.0, 2.2e20));
        let flat = Shear::along(&ray.direction).apply(&corners, &ray);
        assert!(!flat.is_settled());
        // From so far away all corners are equally far in single precision.
        assert_eq!(bvh.nearest(&ray).map(|hit| hit.t), Some(flat.depths[0]), "{ray:?}");
    }
}

/// The ray lies all but in the plane of the first triangle and passes it by, as rational
/// numbers show; in single precision it would pass inside.
#[test]
#[allow(clippy::unreadable_literal, reason = "as the fuzzer found them")]
fn a_ray_along_a_triangle_passes_it_by() {
    let positions = [
        [536870900.0, -5.6586982e-6, -1073741800.0],
        [-2147483600.0, 1610612700.0, 536870900.0],
        [-536870900.0, 1073741800.0, -1.6320854e-11],
        [1610612700.0, -1610612700.0, 9715086.0],
        [0.0, 0.0, 1073741800.0],
        [-536870900.0, 4188756000.0, -1610612700.0],
    ];
    let mesh = Mesh::new(positions.map(Vec3::from).to_vec(), vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    let bvh = Bvh::build(&mesh).unwrap();
    let origin = Vec3::new(1073741800.0, 1073741800.0, 0.0);
    let ray = Ray::new(origin, Vec3::splat(-2147483600.0));
    let hits = bvh.all_hits(&ray);
    assert_eq!(bvh.nearest(&ray), hits.first().copied());
    assert!(hits.iter().all(|hit| hit.primitive == 1), "{hits:?}");
}

/// Where products of coordinates overflow in single precision, no triangle is decided.
#[test]
fn triangles_are_met_however_large() {
    let corners = [[-4.0, -4.0, -4.0], [-4.0, -3.0, -2.0], [-2.0, 0.0, -1.0]].map(Vec3::from);
    let (origin, direction) = (Vec3::new(0.0, 0.0, -4.0), Vec3::new(-2.09, -0.12, 2.97));
    for exponent in (-20..=20).chain(55..=124) {
        let unit = 2.0_f32.powi(exponent);
        for winding in [[0, 1, 2], [0, 2, 1], [1, 2, 0]] {
            let corners = corners.map(|corner| corner * unit).to_vec();
            let mesh = Mesh::new(corners, vec![winding]).unwrap();
            let ray = Ray::new(origin * unit, direction * unit);
            let hit = Bvh::build(&mesh).unwrap().nearest(&ray);
            assert_eq!(hit, brute_force(&mesh, &ray), "{exponent}");
            // Of larger ones the area overflows: they count as having none.
            assert_eq!(hit.is_some(), exponent < 64, "{exponent}");
        }
    }
}
