//! One reflection in a ball against rays that are mirrored one by one.

use super::*;
use traylib_geometry::Facing;
use traylib_math::{Sampler, warp};

fn ball(centre: Vec3, radius: f32) -> BallMirror {
    BallMirror::new(&Sphere::new(centre, radius, Facing::Outward).unwrap())
}

/// Returns the point at which a ray meets a ball around a centre, and the direction in which it
/// goes on, in double precision.
fn mirrored(centre: DVec3, radius: f64, from: DVec3, direction: DVec3) -> [DVec3; 2] {
    let offset = from - centre;
    let along = offset.dot(direction);
    let t = -along - (along * along - offset.length_squared() + radius * radius).sqrt();
    let at = from + t * direction;
    let normal = (at - centre) / radius;
    [at, direction - 2.0 * normal.dot(direction) * normal]
}

/// Pairs of points around a ball, near and far.
fn pairs() -> Vec<[Vec3; 2]> {
    let mut sampler = Sampler::numbered(11, 0);
    let mut point = || {
        let direction = warp::uniform_sphere(sampler.next_2d());
        direction * (1.0 + 3.0 * sampler.next_1d().powi(3))
    };
    (0..2000).map(|_| [point(), point()]).collect()
}

/// A narrow bundle of rays from the light, mirrored one by one, is as wide on a plane that faces it
/// as is said: areas by differences in double precision, which are good to 10⁻⁶.
#[test]
fn a_ball_spreads_light_as_its_rays_do() {
    let (centre, radius) = (Vec3::new(0.3, -0.2, 0.1), 0.75);
    let globe = ball(centre, radius);
    let (centre_64, radius_64) = (centre.as_dvec3(), f64::from(radius));
    let mut checked = 0;
    for [one, other] in pairs() {
        let [from, light] = [one, other].map(|point| centre + radius * point);
        let Some(found) = globe.reflection(from, light) else { continue };
        let from = from.as_dvec3();
        // The ray from the light that is found goes by way of the ball to the point.
        let at = from + found.toward;
        let direction = (at - light.as_dvec3()).normalize();
        let way = (from - at).normalize();
        let cosine = way.dot((at - centre_64) / radius_64);
        if cosine < 0.05 {
            continue;
        }
        let [met, on] = mirrored(centre_64, radius_64, light.as_dvec3(), direction);
        // What rounding makes of a place on the ball, seen from as near as that.
        let gap = [one, other].map(|point| f64::from(point.length()) - 1.0);
        let rounding = 1e-13 / (gap[0].min(gap[1]) * cosine);
        assert!((met - at).length() < rounding, "{met} {at} {rounding}");
        assert!((on - way).length() < rounding, "{on} {way} {rounding}");
        // Its neighbours, on the plane through the point that faces it.
        let (u, v) = direction.any_orthonormal_pair();
        let step = 1e-5 * cosine;
        let landing = |offset: DVec3| {
            let ray = (direction + step * offset).normalize();
            let [at, on] = mirrored(centre_64, radius_64, light.as_dvec3(), ray);
            at + on * ((from - at).dot(way) / on.dot(way))
        };
        let [a, b] = [u, v].map(|axis| (landing(axis) - landing(-axis)) / (2.0 * step));
        let area = a.cross(b).length();
        let ratio = found.spread * area;
        assert!((ratio - 1.0).abs() < 1e-5, "{ratio}: {from} {light} {cosine}");
        checked += 1;
    }
    assert!(checked > 400, "{checked}");
}

/// Cones are aimed at the place that mirrors, and at no other where one of both points is behind
/// the surface.
#[test]
fn cones_are_aimed_at_the_place_that_mirrors() {
    let globe = ball(Vec3::ZERO, 1.0);
    let (mut checked, mut worst) = (0, 0.0_f64);
    for [one, other] in pairs() {
        let Some(found) = globe.reflection(one, other) else { continue };
        let near = one.length().min(other.length());
        let at = one.as_dvec3() + found.toward;
        let cosine = -at.dot(found.toward) / found.toward.length();
        if near < 1.05 || cosine < 0.1 {
            continue;
        }
        let normal = globe.normal_toward(one, other).unwrap();
        worst = worst.max((normal.as_dvec3() - at).length());
        checked += 1;
    }
    assert!(checked > 300, "{checked}");
    assert!(worst < 1e-3, "{worst}");
}

/// Points that see a common part of the ball see one another in it, and no others do.
#[test]
fn a_ball_shows_a_point_wherever_it_can() {
    let globe = ball(Vec3::ZERO, 1.0);
    let (mut shown, mut hidden) = (0, 0);
    for [one, other] in pairs() {
        if one.length() <= 1.0 || other.length() <= 1.0 {
            continue;
        }
        let cap = |point: Vec3| (1.0 / f64::from(point.length())).acos();
        let apart = one.as_dvec3().angle_between(other.as_dvec3());
        let found = globe.reflection(one, other);
        assert_eq!(found.is_some(), apart < cap(one) + cap(other), "{one} {other}");
        shown += u32::from(found.is_some());
        hidden += u32::from(found.is_none());
        // The same from either end.
        let back = globe.reflection(other, one);
        let [there, back] = [found, back].map(|found| found.map_or(0.0, |found| found.spread));
        assert!((there - back).abs() <= 1e-9 * there, "{there} {back}");
    }
    assert!(shown > 500 && hidden > 300, "{shown} {hidden}");
}

/// A ball that is large enough is flat.
#[test]
fn a_large_ball_is_flat() {
    let [from, light] = [Vec3::new(1.0, 0.0, 2.0), Vec3::new(-0.5, 0.3, 1.0)];
    let image = light * Vec3::new(1.0, 1.0, -1.0);
    let globe = ball(-1e6 * Vec3::Z, 1e6);
    let found = globe.reflection(from, light).unwrap();
    let distance_squared = f64::from((image - from).length_squared());
    assert!((found.spread * distance_squared - 1.0).abs() < 1e-4, "{found:?}");
}
