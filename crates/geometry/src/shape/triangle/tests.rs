use super::*;
use crate::f32_filter::Shear;
use crate::testing::{Random, cube, icosphere, triangles};
use crate::{Bvh, Mesh, Options, Precision};

/// Rays from `origin` aimed exactly at corners and at points of edges of a
/// closed mesh that do not find it.
fn leaks(mesh: &Mesh, origin: Vec3, random: &mut Random) -> usize {
    let bvh = Bvh::of_shapes(triangles(mesh)).unwrap();
    let misses = |target: Vec3| usize::from(!bvh.any_hit(&Ray::new(origin, target - origin)));
    let corners = mesh.positions().iter().map(|&p| misses(p)).sum::<usize>();
    let mut edges = 0;
    for corners in mesh.triangles() {
        let [a, b, c] = corners.map(|i| mesh.positions()[i as usize]);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            edges += misses(p.lerp(q, 0.5)) + misses(p.lerp(q, random.number()));
        }
    }
    corners + edges
}

#[test]
fn closed_meshes_have_no_gaps() {
    let mut random = Random::new(1);
    let (ball, cube) = (icosphere(4), cube());
    // Per origin 33 000 rays at the ball and 80 at the cube.
    for _ in 0..5 {
        assert_eq!(leaks(&ball, 0.9 * random.point() / 3.0_f32.sqrt(), &mut random), 0);
    }
    assert_eq!(leaks(&ball, Vec3::ZERO, &mut random), 0);
    for _ in 0..500 {
        assert_eq!(leaks(&cube, random.point(), &mut random), 0);
    }
    assert_eq!(leaks(&cube, Vec3::ZERO, &mut random), 0);
}

/// A ball of 10⁴ times its size away from the origin, and one squeezed flat.
#[test]
fn distant_and_flat_meshes_have_no_gaps() {
    let mut random = Random::new(2);
    let moved = |f: &dyn Fn(Vec3) -> Vec3| {
        let ball = icosphere(3);
        let positions = ball.positions().iter().map(|&p| f(p)).collect();
        Mesh::new(positions, ball.triangles().to_vec()).unwrap()
    };
    let place = Vec3::new(1e4, -3e3, 5e3);
    assert_eq!(leaks(&moved(&|p| p + place), place, &mut random), 0);
    let flat = moved(&|p| p * Vec3::new(1.0, 1e-4, 1.0));
    for _ in 0..10 {
        let inside = random.point() * Vec3::new(0.5, 3e-5, 0.5);
        assert_eq!(leaks(&flat, inside, &mut random), 0);
    }
}

#[test]
fn corners_have_their_barycentric_coordinates() {
    let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let above = |x, y| Ray::new(Vec3::new(x, y, 2.0), Vec3::new(0.0, -0.0, -4.0));
    let meet = |x, y| triangle.intersect(&above(x, y), Sides::Front).map(|h| (h.t, h.u, h.v));
    assert_eq!(meet(0.0, 0.0), Some((0.5, 0.0, 0.0)));
    assert_eq!(meet(1.0, 0.0), Some((0.5, 1.0, 0.0)));
    assert_eq!(meet(0.25, 0.5), Some((0.5, 0.25, 0.5)));
    assert_eq!(meet(0.6, 0.5), None);
}

#[test]
fn a_ray_in_the_plane_misses() {
    let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    for y in [0.0, 0.25] {
        let ray = Ray::new(Vec3::new(-1.0, y, 0.0), Vec3::X);
        assert_eq!(triangle.intersect(&ray, Sides::Both), None);
    }
}

/// In single precision the normal of such a triangle would be noise.
#[test]
fn the_normal_of_a_sliver_is_perpendicular() {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let (a, along) = (random.point(), random.point());
        let Ok(sliver) = Triangle::new(a, a + along, a + 0.5 * along + 1e-5 * random.point())
        else {
            continue;
        };
        let [_, b, c] = sliver.corners();
        assert!(sliver.normal().dot(b - a).abs() < 3e-7 * along.length());
        assert!(sliver.normal().dot(c - a).abs() < 3e-7 * along.length());
    }
}

/// The ray crosses the line of an edge 63 edges away; two of the three edge functions
/// are rounded to zero.
#[test]
#[allow(clippy::unreadable_literal, reason = "as the fuzzer found them")]
fn a_ray_that_passes_far_beyond_an_edge_misses() {
    let corners = [
        Vec3::new(-0.9420121, -0.9552912, -0.23872508),
        Vec3::new(-1.7036078, -0.6134155, -1.0112234),
        Vec3::new(-1.6129376, -0.65569144, -0.9211821),
    ];
    let origin = Vec3::new(-65.84417, 1.1488686, -99.046616);
    let ray = Ray::new(origin, Vec3::new(17.017536, 19.390957, 50.237778));
    let sheared = Shear::along(&ray.direction).apply(&corners, &ray);
    let may_meet = sheared.may_meet(f32::INFINITY);
    assert!(may_meet && sheared.edges[0] == 0.0 && sheared.edges[1] == 0.0, "{sheared:?}");
    let [a, b, c] = corners;
    let triangle = Triangle::new(a, b, c).unwrap();
    assert_eq!(triangle.intersect(&ray, Sides::Both), None);
    let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
    for precision in [Precision::Watertight, Precision::Fast] {
        let options = Options { precision, ..Options::default() };
        assert!(!Bvh::build_with(&mesh, options).unwrap().any_hit(&ray));
    }
}
