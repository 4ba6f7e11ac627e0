use super::*;
use crate::Facing;
use crate::testing::Random;
use std::f32::consts::PI;
use std::f64::consts::TAU;
use traylib_math::solid_angle_per_area;

/// Mean of `f` over the centres of an n × n grid on the unit square.
fn mean(n: usize, f: impl Fn(Vec2) -> f32) -> f64 {
    let centre = |i: usize| (i as f32 + 0.5) / n as f32;
    let values = (0..n * n).map(|i| f64::from(f(Vec2::new(centre(i % n), centre(i / n)))));
    values.sum::<f64>() / (n * n) as f64
}

fn sphere(radius: f32, facing: Facing) -> Primitive {
    Primitive::Sphere(Sphere::new(Vec3::new(1.0, -2.0, 0.5), radius, facing).unwrap())
}

/// Seen from 10⁴ radii to a hundredth of a radius away.
const DISTANCES: [f32; 5] = [1e4, 30.0, 2.0, 1.1, 1.01];

fn viewpoint(distance: f32) -> Vec3 {
    Vec3::new(1.0, -2.0, 0.5) + 0.25 * distance * Vec3::new(0.36, 0.48, -0.8)
}

/// The density of the cone is what its samples have: weighted by solid angle
/// over density they give the solid angle of the sphere,
/// 2π(1 − cosθ) with sinθ = r/d, each exactly.
#[test]
fn cone_samples_fill_the_solid_angle() {
    for distance in DISTANCES {
        let from = viewpoint(distance);
        let lamp = sphere(0.25, Facing::Outward);
        let sin = 1.0 / f64::from(distance);
        let exact = TAU * sin * sin / (1.0 + (1.0 - sin * sin).sqrt());
        let seen = mean(32, |u| {
            let (site, pdf) = lamp.sample_toward(from, u);
            let back = from - site.position;
            let cosine = site.normal.dot(back) / back.length();
            assert!(cosine > 0.0, "{distance} {u}: {cosine}");
            assert_eq!(pdf, lamp.pdf_toward(from, site.position, site.normal));
            solid_angle_per_area(cosine, back.length_squared()) / pdf.0
        });
        assert!((seen / exact - 1.0).abs() < 1e-3, "{distance}: {seen} {exact}");
    }
}

/// Over points uniform by area the density has mean 1/area.
#[test]
fn the_density_toward_a_point_integrates_to_one() {
    for distance in [4.0, 2.0, 1.5] {
        let from = viewpoint(distance);
        for lamp in [sphere(0.25, Facing::Outward), sphere(0.25, Facing::Inward)] {
            let integral = mean(512, |u| {
                let site = lamp.sample_area(u);
                lamp.area() * lamp.pdf_toward(from, site.position, site.normal).0
            });
            assert!((integral - 1.0).abs() < 2e-2, "{distance}: {integral}");
        }
    }
}

/// The cone's samples lie evenly in angle: the share of them within half the
/// solid angle is a half.
#[test]
fn cone_samples_are_uniform_in_angle() {
    for distance in DISTANCES {
        let from = viewpoint(distance);
        let axis = (viewpoint(0.0) - from).normalize();
        let sin = 1.0 / distance;
        let rim = sin * sin / (1.0 + (1.0 - sin * sin).sqrt());
        let lamp = sphere(0.25, Facing::Outward);
        let inner = mean(64, |u| {
            let toward = (lamp.sample_toward(from, u).0.position - from).normalize();
            let one_minus_cos = 0.5 * (toward - axis).length_squared();
            f32::from(one_minus_cos < 0.5 * rim)
        });
        assert!((inner - 0.5).abs() < 0.05, "{distance}: {inner}");
    }
}

#[test]
fn all_else_is_sampled_by_area() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let shape = random.primitive(Vec3::ZERO);
        let place = 3.0 * random.point();
        let from = match shape.form() {
            Form::Ball(ball) if ball.facing() == Facing::Outward => ball.centre(),
            // From far away.
            Form::Flat {
                outline: Outline::Triangle(_) | Outline::Parallelogram { .. }, ..
            } => 100.0 * random.direction(),
            Form::Flat { outline: Outline::Circle { .. }, .. } | Form::Ball(_) | Form::Bent(_) => {
                place
            }
        };
        let (site, pdf) = shape.sample_toward(from, random.square());
        assert_eq!(pdf.0, 1.0 / shape.area());
        assert!(shape.bounds().grown(site.error).contains(site.position));
    }
}

/// Points uniform by area have the centroid of the shape; on disks and spheres
/// the mean square of their distance from it is r²/2 and r², on a ring
/// (r² + R²)/2. The centroid of a cone is at (r + 2R)/(3r + 3R) of its axis.
#[test]
fn area_samples_are_uniform() {
    let (a, b, c) = (Vec3::X, Vec3::new(0.0, 3.0, 1.0), Vec3::new(-1.0, 0.0, 2.0));
    let shapes = [
        (Primitive::Triangle(Triangle::new(a, b, c).unwrap()), (a + b + c) / 3.0, None),
        (Primitive::Quad(Quad::new(a, b, c).unwrap()), a + 0.5 * (b + c), None),
        (Primitive::Disk(Disk::new(a, b, 2.0).unwrap()), a, Some(2.0)),
        (Primitive::Disk(Disk::ring(a, b, 1.0, 2.0).unwrap()), a, Some(2.5)),
        (cone([a, b], [1.0, 0.5]), a.lerp(b, 4.0 / 9.0), None),
        (cone([a, c], [0.0, 2.0]), a.lerp(c, 2.0 / 3.0), None),
        // r² + l²/12.
        (cone([c, c + b], [2.0; 2]), c + 0.5 * b, Some(4.0 + 10.0 / 12.0)),
        (Primitive::Sphere(Sphere::new(c, 2.0, Facing::Outward).unwrap()), c, Some(4.0)),
    ];
    for (shape, centre, square) in shapes {
        let position = |axis: usize| mean(64, |u| shape.sample_area(u).position[axis]) as f32;
        let found = Vec3::new(position(0), position(1), position(2));
        assert!(found.distance(centre) < 3e-3, "{shape:?}: {found}");
        let spread = mean(64, |u| shape.sample_area(u).position.distance_squared(centre));
        assert!(square.is_none_or(|s: f64| (spread / s - 1.0).abs() < 1e-2), "{shape:?}");
    }
}

fn cone(ends: [Vec3; 2], radii: [f32; 2]) -> Primitive {
    Primitive::Cone(Cone::new(ends, radii, Facing::Outward).unwrap())
}

#[test]
fn areas_are_known() {
    let ring = Disk::ring(Vec3::ONE, Vec3::Y, 3.0, 5.0).unwrap();
    assert_eq!(Primitive::Disk(ring).area(), 16.0 * PI);
    let ends = [Vec3::ONE, Vec3::new(1.0, 5.0, 1.0)];
    assert_eq!(cone(ends, [0.0, 3.0]).area(), 15.0 * PI);
    assert_eq!(cone(ends, [4.0, 1.0]).area(), 25.0 * PI);
    assert_eq!(cone(ends, [0.5, 0.5]).area(), 4.0 * PI);
    let quad = Primitive::Quad(Quad::new(Vec3::ONE, 2.0 * Vec3::X, Vec3::ONE).unwrap());
    assert_eq!(quad.area(), 8.0_f32.sqrt());
    let triangle = Triangle::new(Vec3::ZERO, 3.0 * Vec3::X, 4.0 * Vec3::Y).unwrap();
    assert_eq!(Primitive::Triangle(triangle).area(), 6.0);
    assert!((sphere(0.5, Facing::Inward).area() - PI).abs() < 1e-6);
}

/// The angle between two directions, without arc cosines.
fn angle(a: Vec3, b: Vec3) -> f64 {
    let (a, b) = (a.as_dvec3(), b.as_dvec3());
    a.cross(b).length().atan2(a.dot(b))
}

/// Shapes of all kinds, slivers among them, with normals of even pieces of their
/// surface: 64 along, 64 around.
fn shapes_with_normals() -> Vec<(Primitive, Vec<Vec3>)> {
    let mut random = Random::new(2);
    let centre = |i: u16| (f32::from(i) + 0.5) / 64.0;
    let pieces = || (0..64 * 64).map(|i| Vec2::new(centre(i / 64), centre(i % 64)));
    let mut next = |i: usize| {
        let place = 3.0 * random.point();
        if i.is_multiple_of(2) { random.primitive(place) } else { random.sliver(place) }
    };
    let with_normals =
        |shape: Primitive| (shape, pieces().map(|u| shape.sample_area(u).normal).collect());
    (0..200).map(|i| with_normals(next(i))).collect()
}

/// The cone of normals holds them all, to a few roundings of their coordinates. It is
/// no wider than needed on what is flat or a cone, whose normals are a circle.
#[test]
fn normals_are_where_they_are_said_to_be() {
    for (shape, normals) in shapes_with_normals() {
        let Normals { axis, half_angle } = shape.normals();
        for normal in normals {
            let off = angle(axis, normal) - half_angle;
            assert!(off < 3e-7, "{shape:?}: {normal} is {off} outside");
            let round = matches!(shape, Primitive::Sphere(_));
            assert!(round || off > -3e-7, "{shape:?}: {normal} is {off} inside");
        }
    }
}

/// No direction sees a larger shadow, but for 2.1 % on cones, and some direction sees
/// one as large. The pieces are good to two thousandths, 200 directions
/// in a half plane, from the axis to its opposite, as well.
#[test]
fn the_largest_shadow_is_no_smaller_and_no_larger() {
    for (shape, normals) in shapes_with_normals() {
        let axis = shape.normals().axis;
        let across = axis.any_orthonormal_vector();
        let shadow = |toward: Vec3| {
            let sum: f64 = normals.iter().map(|n| f64::from(n.dot(toward).max(0.0))).sum();
            sum / normals.len() as f64 * f64::from(shape.area())
        };
        let angles = (0..=200_u8).map(|i| f32::from(i) / 200.0 * PI);
        let largest = angles.map(|angle| shadow(axis * angle.cos() + across * angle.sin()));
        let ratio = largest.fold(0.0, f64::max) / f64::from(shape.largest_shadow());
        let most = if matches!(shape, Primitive::Cone(_)) { 1.023 } else { 1.002 };
        assert!((0.998..most).contains(&ratio), "{shape:?}: {ratio}");
    }
}
