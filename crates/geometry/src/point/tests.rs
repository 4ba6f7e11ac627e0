mod coordinate_planes;

use super::*;
use crate::testing::Random;
use crate::testing::shape::is_final;
use crate::{Cone, Disk, Facing, Hit, Primitive, Quad, Sides, Sphere, Triangle};

/// A unit direction on the side of `normal`, often almost along the surface.
fn leaving(normal: Vec3, random: &mut Random) -> Vec3 {
    let any = random.direction();
    let flat = (any - normal * any.dot(normal)).normalize();
    let height = random.magnitude(1e-9);
    (flat + height * normal).normalize()
}

fn some_shape(i: u32, random: &mut Random) -> Primitive {
    let distance = if i.is_multiple_of(2) { 1.0 } else { random.magnitude(1e4) };
    let place = distance * random.point();
    if i.is_multiple_of(3) { random.sliver(place) } else { random.primitive(place) }
}

#[test]
fn rays_never_meet_the_surface_they_leave() {
    let mut random = Random::new(1);
    for i in 0..200_000 {
        let shape = some_shape(i, &mut random);
        let mut site = shape.sample_area(random.square());
        if i % 5 == 0 {
            // A site as a hit from somewhere gives it.
            let from = site.position + random.magnitude(1e4) * random.direction();
            let ray = Ray::new(from, site.position - from);
            let Some(hit) = shape.intersect(&ray, Sides::Both) else { continue };
            site = shape.site(&ray, &Hit { t: hit.t, primitive: 0, u: hit.u, v: hit.v });
        }
        for side in [1.0, -1.0] {
            let out = leaving(side * site.normal, &mut random);
            let ray = Ray::new(site.ray_origin(out), out);
            let again = shape.intersect(&ray, Sides::Both);
            // Almost along the surface, rounding decides the side.
            if is_final(&shape, out.dot(site.normal)) {
                assert_eq!(again, None, "{shape:?} {site:?} {out}");
            }
        }
    }
}

/// A shape of size one that passes through the origin up to rounding, and the
/// site there: its coordinates are nothing but rounding errors.
fn through_origin(kind: u32, random: &mut Random) -> (Primitive, SurfaceSite) {
    let (a, b, at) = (random.point(), random.point(), 0.4 * random.square());
    let corner = -(at.x * a + at.y * b);
    let nowhere = Hit { t: 0.0, primitive: 0, u: at.x, v: at.y };
    let shape = match kind % 5 {
        0 => Primitive::Quad(Quad::new(corner, a, b).unwrap()),
        1 => Primitive::Triangle(Triangle::new(corner, corner + a, corner + b).unwrap()),
        2 => Primitive::Sphere(Sphere::new(a, a.length(), Facing::Outward).unwrap()),
        3 => {
            let radius = a.length();
            let axis = a.any_orthogonal_vector();
            let ends = [a - axis * at.x, a + axis];
            Primitive::Cone(Cone::new(ends, [radius, radius], Facing::Outward).unwrap())
        }
        _ => Primitive::Disk(Disk::new(a, a.any_orthogonal_vector(), 2.0).unwrap()),
    };
    (shape, shape.site(&Ray::new(Vec3::ZERO, b), &nowhere))
}

#[test]
fn rays_leave_surfaces_at_the_origin() {
    let mut random = Random::new(6);
    for kind in 0..100_000 {
        let (shape, site) = through_origin(kind, &mut random);
        for side in [1.0, -1.0] {
            let out = leaving(side * site.normal, &mut random);
            if is_final(&shape, out.dot(site.normal)) {
                let again = shape.intersect(&Ray::new(site.ray_origin(out), out), Sides::Both);
                assert_eq!(again, None, "{shape:?} {site:?} {out}");
            }
        }
    }
}

/// Inside a sphere a ray meets the other side, 2r·cosθ away, and not the point
/// it leaves.
#[test]
fn rays_inside_a_sphere_cross_it() {
    let mut random = Random::new(2);
    let mut crossings = 0;
    while crossings < 20_000 {
        let place = random.magnitude(1e3) * random.point();
        let Primitive::Sphere(sphere) = random.primitive(place) else { continue };
        let site = Primitive::Sphere(sphere).sample_area(random.square());
        let inward = (sphere.centre() - site.position).normalize();
        let out = (inward + 0.9 * random.direction()).normalize();
        let hit = sphere.intersect(&Ray::new(site.ray_origin(out), out), Sides::Both).unwrap();
        let chord = 2.0 * sphere.radius() * out.dot(inward);
        assert!((hit.t - chord).abs() < 0.05 * chord, "{sphere:?}: {} {chord}", hit.t);
        crossings += 1;
    }
}

#[test]
fn segments_are_not_blocked_by_their_ends() {
    let mut random = Random::new(3);
    for i in 0..200_000 {
        let (a, b) = (some_shape(i, &mut random), some_shape(i / 2, &mut random));
        let (from, to) = (a.sample_area(random.square()), b.sample_area(random.square()));
        let between = to.position - from.position;
        let segment = from.segment_to(&to);
        let back = to.segment_to(&from);
        for (shape, site, direction) in [(a, from, between), (b, to, -between)] {
            if is_final(&shape, direction.dot(site.normal)) {
                assert_eq!(shape.intersect(&segment, Sides::Both), None, "{shape:?} {site:?}");
                assert_eq!(shape.intersect(&back, Sides::Both), None, "{shape:?} {site:?}");
            }
        }
    }
}

/// A point light a long way off, or next to the surface.
#[test]
fn segments_to_free_points_leave_the_surface() {
    let mut random = Random::new(4);
    for i in 0..50_000 {
        let shape = some_shape(i, &mut random);
        let site = shape.sample_area(random.square());
        let out = leaving(site.normal, &mut random);
        let light = site.position + (1e-3 * random.magnitude(1e7)) * out;
        let clear = (light - site.position).dot(site.normal) > site.error.length();
        if clear && is_final(&shape, 1.0) {
            for segment in [site.segment_to_point(light), site.segment_from_point(light)] {
                assert_eq!(shape.intersect(&segment, Sides::Both), None, "{shape:?} {site:?}");
            }
        }
    }
}

/// Things close above a surface are not skipped: the lift is a millionth of the shape's size and
/// distance from the origin at most.
#[test]
fn lifts_are_small() {
    let mut random = Random::new(5);
    for i in 0..20_000 {
        let shape = some_shape(i, &mut random);
        let site = shape.sample_area(random.square());
        let bounds = shape.bounds();
        let size = bounds.extent().length() + site.position.length();
        let lift = site.ray_origin(site.normal).distance(site.position);
        assert!(lift < 3e-6 * size, "{shape:?}: {lift}");
    }
}
