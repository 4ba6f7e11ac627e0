use super::*;
use crate::{Hit, Primitive};

fn ball(facing: Facing) -> Sphere {
    Sphere::new(Vec3::new(1.0, 2.0, 3.0), 0.5, facing).unwrap()
}

#[test]
fn both_crossings_are_found() {
    let (inside, outside) = (Vec3::new(1.25, 2.0, 3.0), Vec3::new(-1.0, 2.0, 3.0));
    let from = |origin, sides, facing| {
        ball(facing).intersect(&Ray::new(origin, 0.5 * Vec3::X), sides).map(|h| h.t)
    };
    for facing in [Facing::Outward, Facing::Inward] {
        assert_eq!(from(outside, Sides::Both, facing), Some(3.0));
        assert_eq!(from(inside, Sides::Both, facing), Some(0.5));
    }
    assert_eq!(from(outside, Sides::Front, Facing::Outward), Some(3.0));
    assert_eq!(from(outside, Sides::Front, Facing::Inward), Some(5.0));
    assert_eq!(from(inside, Sides::Front, Facing::Outward), None);
    assert_eq!(from(inside, Sides::Front, Facing::Inward), Some(0.5));
}

/// The way to the point beside the centre is zero with either sign.
#[test]
fn rays_from_beside_the_centre_meet_the_far_side() {
    let hollow = Sphere::new(Vec3::ZERO, 0.5, Facing::Inward).unwrap();
    for origin in [Vec3::ZERO, -Vec3::ZERO, 0.3 * Vec3::Y, -0.3 * Vec3::Y] {
        for direction in [Vec3::X, Vec3::NEG_X, Vec3::Z, Vec3::new(-1.0, 0.0, -1.0)] {
            let ray = Ray::new(origin, direction);
            for sides in [Sides::Both, Sides::Front] {
                let hit = hollow.intersect(&ray, sides);
                let room = 0.25 - origin.length_squared();
                let expected = (room / direction.length_squared()).sqrt();
                let close = hit.is_some_and(|hit| (hit.t - expected).abs() < 1e-6);
                assert!(close, "{ray:?} {sides:?}: {hit:?}");
            }
        }
    }
}

#[test]
fn a_segment_that_ends_inside_meets_once() {
    let sphere = ball(Facing::Inward);
    let centre = sphere.centre();
    let segment = Ray::segment(centre - Vec3::Y, centre);
    assert_eq!(sphere.intersect(&segment, Sides::Both).map(|h| h.t), Some(0.5));
    assert_eq!(sphere.intersect(&segment, Sides::Front), None);
    let short = Ray::segment(centre, centre + 0.25 * Vec3::Y);
    assert_eq!(sphere.intersect(&short, Sides::Both), None);
}

/// From 10⁵ radii away the textbook discriminant has lost all its digits.
#[test]
fn far_cameras_see_round_spheres() {
    let sphere = Sphere::new(Vec3::ZERO, 1.0, Facing::Outward).unwrap();
    let at = |y: f32| {
        let ray = Ray::new(Vec3::new(-1e5, y, 0.0), 3.0 * Vec3::X);
        let hit = sphere.intersect(&ray, Sides::Both)?;
        let hit = Hit { t: hit.t, primitive: 0, u: 0.0, v: 0.0 };
        Some(Primitive::Sphere(sphere).site(&ray, &hit))
    };
    for y in [0.0, 0.5, 0.99, 0.9999] {
        let site = at(y).unwrap();
        // The ray's own t is good to 10⁵·2⁻²³ ≈ 0.01; the site is on the sphere.
        assert!((site.position.length() - 1.0).abs() < 3e-7, "{site:?}");
        assert!((site.position.y - y).abs() < 2e-2, "{site:?}");
    }
    assert!(at(1.0001).is_none());
}

/// Products of lengths leave single precision long before lengths do.
#[test]
fn balls_throw_shadows_at_any_scale() {
    for power in [-40, 0, 33, 40, 55] {
        let scale = 2.0_f32.powi(power);
        let ball = Sphere::new(7.8e2 * scale * Vec3::X, 0.07 * scale, Facing::Outward).unwrap();
        let segment = Ray::segment(0.7 * scale * Vec3::X, 781.9 * scale * Vec3::X);
        let hit = ball.intersect(&segment, Sides::Both).unwrap();
        let plain = (7.8e2 - 0.07 - 0.7) / (781.9 - 0.7);
        assert!((hit.t - plain).abs() < 1e-6, "2^{power}: {hit:?}");
    }
}

/// A ball as large as the earth, whose top is the origin: rays leave it, and start no
/// further off than a tenth of a millimetre.
#[test]
fn the_earth_is_smooth() {
    let earth = Sphere::new(Vec3::Y * -6.4e6, 6.4e6, Facing::Outward).unwrap();
    for i in 0..1000 {
        let angle = 0.01 * i as f32;
        let target = Vec3::new(angle.cos(), 0.0, angle.sin()) * 0.01 * i as f32;
        let ray = Ray::new(target + Vec3::new(0.3, 1.0, -0.2), Vec3::new(-0.3, -1.0, 0.2));
        let hit = earth.intersect(&ray, Sides::Both).unwrap();
        let site = earth.site(&ray, hit.t);
        // Ten metres away the ground has sunk by 8 µm.
        assert!(site.position.y.abs() < 1e-5 && site.position.distance(target) < 1e-5, "{site:?}");
        for out in [Vec3::Y, Vec3::new(1.0, 1e-4, 0.0), Vec3::new(0.0, 1e-3, -1.0)] {
            let origin = site.ray_origin(out);
            assert!(origin.distance(site.position) < 1e-4, "{site:?}");
            assert_eq!(
                earth.intersect(&Ray::new(origin, out), Sides::Both),
                None,
                "{site:?} {out}"
            );
        }
    }
}
