use super::*;
use crate::testing::Random;

mod leaving;
mod measure;
mod oracle;

fn cone(ends: [Vec3; 2], radii: [f32; 2]) -> Cone {
    Cone::new(ends, radii, Facing::Outward).unwrap()
}

/// A cone of any proportions near the origin or far from it: from flat ones to
/// wires, a third each cylinders and with a tip.
fn any_cone(random: &mut Random) -> Cone {
    let place = random.magnitude(1e3) * random.point();
    let ends = [place, place + random.magnitude(1e-3) * random.point()];
    let (radius, part) = (random.magnitude(1e-4), random.number());
    let radii = match (3.0 * random.number()) as u32 {
        0 => [radius, radius],
        1 => [0.0, radius],
        _ => [radius, part * radius],
    };
    let [one, other] = if random.number() < 0.5 { radii } else { [radii[1], radii[0]] };
    let facing = if random.number() < 0.5 { Facing::Outward } else { Facing::Inward };
    Cone::new(ends, [one, other], facing).unwrap_or_else(|_| any_cone(random))
}

/// Returns the t at which a ray meets a tube of radius 1/2 around the z axis from 1 to 3.
fn meet_tube(origin: [f32; 3], direction: [f32; 3], sides: Sides) -> Option<f32> {
    let tube = cone([Vec3::Z, 3.0 * Vec3::Z], [0.5, 0.5]);
    tube.intersect(&Ray::new(origin.into(), direction.into()), sides).map(|hit| hit.t)
}

#[test]
fn a_tube_is_met_from_outside_and_inside() {
    let across = [0.25, 0.0, 0.0];
    assert_eq!(meet_tube([-1.0, 0.0, 2.0], across, Sides::Both), Some(2.0));
    assert_eq!(meet_tube([-1.0, 0.0, 2.0], across, Sides::Front), Some(2.0));
    assert_eq!(meet_tube([0.25, 0.0, 2.0], across, Sides::Both), Some(1.0));
    assert_eq!(meet_tube([0.25, 0.0, 2.0], across, Sides::Front), None);
    assert_eq!(meet_tube([1.0, 0.0, 2.0], across, Sides::Both), None);
    // Its rims belong to it, and nothing beyond.
    assert_eq!(meet_tube([-1.0, 0.0, 1.0], across, Sides::Both), Some(2.0));
    assert_eq!(meet_tube([-1.0, 0.0, 3.0], across, Sides::Both), Some(2.0));
    assert_eq!(meet_tube([-1.0, 0.0, 3.001], across, Sides::Both), None);
    // Over the near rim, onto the far side.
    assert_eq!(meet_tube([-1.25, 0.0, 4.0], [1.0, 0.0, -1.0], Sides::Both), Some(1.75));
    assert_eq!(meet_tube([-1.25, 0.0, 4.0], [1.0, 0.0, -1.0], Sides::Front), None);
}

#[test]
fn a_tube_is_open_along_its_axis() {
    for x in [0.0, 0.25, 0.75] {
        for z in [0.0, 2.0, 4.0] {
            for up in [1.0, -1.0] {
                assert_eq!(meet_tube([x, 0.0, z], [0.0, 0.0, up], Sides::Both), None);
            }
        }
    }
}

#[test]
fn the_other_half_of_a_cone_is_not_there() {
    let hat = cone([Vec3::ZERO, Vec3::Z], [1.0, 0.0]);
    let meet = |x: f32, z: f32| {
        hat.intersect(&Ray::new(Vec3::new(x, 0.0, z), Vec3::X), Sides::Both).map(|hit| hit.t)
    };
    assert_eq!(meet(-2.0, 0.5), Some(1.5));
    assert_eq!(meet(0.0, 0.5), Some(0.5));
    assert_eq!(meet(-2.0, 1.5), None);
}

/// Such a ray meets the cone once: the equation has no square.
#[test]
fn rays_parallel_to_the_side_meet_the_opposite_one() {
    let hat = cone([Vec3::ZERO, Vec3::Z], [1.0, 0.0]);
    let parallel = Vec3::new(-1.0, 0.0, 1.0);
    let meet = |x: f32, direction: Vec3| {
        hat.intersect(&Ray::new(x * Vec3::X, direction), Sides::Both).map(|hit| hit.t)
    };
    assert_eq!(meet(0.5, parallel), Some(0.75));
    assert_eq!(meet(0.5, -parallel), None);
    assert_eq!(meet(1.5, parallel), None);
}

#[test]
fn normals_stand_on_the_side_and_face_as_told() {
    let mut random = Random::new(1);
    for _ in 0..20_000 {
        let cone = any_cone(&mut random);
        let normal = cone.sample_area(random.square()).normal.as_dvec3();
        let (axis, widening) = (cone.axis(), cone.widening());
        let along = normal.dot(axis) / axis.length();
        // Perpendicular to the side, which goes outward by `widening` on the
        // length of the axis.
        let expected = -widening / cone.slant_squared().sqrt() * cone.facing().turn(1.0);
        assert!((along - expected).abs() < 2e-7, "{cone:?}");
        assert!((normal.length() - 1.0).abs() < 2e-7, "{cone:?}");
    }
    let funnel = cone([Vec3::ZERO, Vec3::Z], [0.0, 1.0]);
    let site = funnel.site_near(DVec3::new(0.5, 0.0, 0.5));
    assert_eq!(site.normal.x, -site.normal.z);
    assert!(site.normal.x > 0.0);
    assert_eq!(site.position, Vec3::new(0.5, 0.0, 0.5));
}

/// t of a wire's hit from 10⁷ radii away is off by more than its radius.
#[test]
fn far_cameras_see_round_wires() {
    let radius = 1e-4;
    let wire = cone([-Vec3::Z, Vec3::Z], [radius; 2]);
    for part in [0.0, 0.5, -0.9] {
        let ray = Ray::new(Vec3::new(-1000.1, part * radius, 0.0), Vec3::X);
        let hit = wire.intersect(&ray, Sides::Front).unwrap();
        let site = wire.site(&ray, hit.t);
        let expected = Vec3::new(-(1.0 - part * part).sqrt(), part, 0.0);
        assert!(site.normal.distance(expected) < 1e-6, "{site:?} {expected}");
        assert!(site.position.distance(radius * expected) < 1e-6 * radius, "{site:?}");
    }
}

#[test]
fn a_ray_down_the_axis_has_a_site_where_it_meets_the_tip() {
    let hat = cone([Vec3::ZERO, Vec3::Z], [1.0, 0.0]);
    let ray = Ray::new(2.0 * Vec3::Z, Vec3::NEG_Z);
    let site = hat.site(&ray, 1.0);
    assert_eq!(site.position, Vec3::Z);
    assert!((site.normal.z - 0.5_f32.sqrt()).abs() < 1e-7, "{site:?}");
}

#[test]
fn what_is_no_cone_is_refused() {
    let (o, x) = (Vec3::ZERO, Vec3::X);
    let cone = |to, radii| Cone::new([o, to], radii, Facing::Outward);
    assert_eq!(cone(o, [1.0, 0.5]), Err(Error::NoAxis));
    assert_eq!(cone(-o, [1.0, 0.5]), Err(Error::NoAxis));
    assert_eq!(cone(x, [0.0, 0.0]), Err(Error::NoRadius));
    assert_eq!(cone(x, [1.0, -0.5]), Err(Error::NoRadius));
    assert_eq!(cone(x, [-1.0, 1.0]), Err(Error::NoRadius));
    assert_eq!(cone(x, [1.0, f32::NAN]), Err(Error::NotFinite));
    assert_eq!(cone(x, [f32::INFINITY, 1.0]), Err(Error::NotFinite));
    assert_eq!(cone(f32::NAN * x, [1.0, 1.0]), Err(Error::NotFinite));
    assert_eq!(cone(f32::MAX * x, [1.0, 1.0]), Err(Error::NoArea));
    assert_eq!(cone(f32::MAX * x, [1e37, 1e37]), Err(Error::NotFinite));
    assert_eq!(cone(1e-30 * x, [1e-30, 0.0]), Err(Error::NoArea));
    assert_eq!(cone(x, [0.0, 1.0]).map(|cone| cone.radii()), Ok([0.0, 1.0]));
}
