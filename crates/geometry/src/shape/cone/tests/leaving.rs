//! Rays that leave a cone.

use super::*;

/// Any place, often at a rim or next to the tip.
fn some_site(cone: &Cone, random: &mut Random) -> SurfaceSite {
    let last = 1.0 - f32::EPSILON / 2.0;
    let along = match (4.0 * random.number()) as u32 {
        0 => 0.0,
        1 => random.magnitude(1e-7).min(last),
        2 => last - random.magnitude(1e-7) * last,
        _ => random.number(),
    };
    let site = cone.sample_area(Vec2::new(along, random.number()));
    if random.number() < 0.5 {
        return site;
    }
    // As a hit from somewhere gives it.
    let from = site.position + random.magnitude(1e4) * random.direction();
    let ray = Ray::new(from, site.position - from);
    cone.intersect(&ray, Sides::Both).map_or(site, |hit| cone.site(&ray, hit.t))
}

/// A direction on the side of `normal`, often almost along the surface, where
/// rounding may put it on the other one, and as often as not along the axis.
fn leaving(cone: &Cone, normal: Vec3, random: &mut Random) -> Vec3 {
    let aside = random.magnitude(1e-6) * random.direction();
    let along = cone.axis().normalize().as_vec3();
    let any = if random.number() < 0.5 { along + aside } else { random.direction() };
    let flat = (any - normal * any.dot(normal)).normalize_or(along);
    (flat + random.magnitude(1e-9) * normal).normalize()
}

fn outward(cone: &Cone, site: &SurfaceSite) -> Vec3 {
    cone.facing.turn(site.normal)
}

/// The solid that it bounds is convex: outside, nothing is met again.
#[test]
fn rays_that_leave_outward_are_gone() {
    let mut random = Random::new(1);
    for _ in 0..300_000 {
        let cone = any_cone(&mut random);
        let site = some_site(&cone, &mut random);
        let normal = outward(&cone, &site);
        let out = leaving(&cone, normal, &mut random);
        if out.dot(normal) > 0.0 {
            let ray = Ray::new(site.ray_origin(out), out);
            assert_eq!(cone.intersect(&ray, Sides::Both), None, "{cone:?} {site:?} {out}");
        }
    }
}

/// Inward the other side may be met: at a cosine c with the normal no nearer
/// than 2cρ, with ρ the radius there. Where the cone is no thicker than the lift
/// over the rounding of its place, there is no inside to leave into.
#[test]
fn rays_that_leave_inward_cross_the_inside() {
    let mut random = Random::new(2);
    let (mut crossed, mut narrow) = (0, 0);
    for _ in 0..300_000 {
        let cone = any_cone(&mut random);
        let site = some_site(&cone, &mut random);
        let normal = -outward(&cone, &site);
        let out = leaving(&cone, normal, &mut random);
        if out.dot(normal) <= 0.0 {
            continue;
        }
        let ray = Ray::new(site.ray_origin(out), out);
        let lift = ray.origin.distance(site.position);
        let from_end = difference(site.position, cone.ends[0]);
        let radius = from_end.cross(cone.axis()).length() / cone.axis().length();
        if radius < 100.0 * f64::from(lift) {
            narrow += 1;
            continue;
        }
        let Some(hit) = cone.intersect(&ray, Sides::Both) else { continue };
        // The cosine is of rounded vectors, and the lift is a hundredth of ρ.
        let nearest = 2.0 * radius * (f64::from(out.dot(normal)) - 3e-7) * 0.98;
        assert!(f64::from(hit.t) > nearest, "{cone:?} {site:?} {out}: {} {nearest}", hit.t);
        // Nor is what it leaves met under its feet.
        assert!(hit.t > lift, "{cone:?} {site:?} {out}: {} {lift}", hit.t);
        crossed += 1;
    }
    assert!(crossed > 60_000 && narrow < 100_000, "{crossed} {narrow}");
}

/// Far from the origin across its side, where rounding moves a point along the
/// bend of a wire further than it moves it along the normal.
#[test]
fn wires_keep_what_is_inside() {
    let mut random = Random::new(3);
    for _ in 0..50_000 {
        let place = Vec3::new(0.0, 100.0 + random.number(), 0.0);
        let wire = cone([place, place + Vec3::new(0.0, 0.3, 1.0)], [2e-4; 2]);
        // Where the normal is along x but for a hundred thousandth.
        let aside = 1e-5 * random.point().as_dvec3();
        let side = wire.across(DVec3::X + aside);
        let site = wire.site_at(f64::from(random.number()), side);
        let out = leaving(&wire, -site.normal, &mut random);
        if out.dot(site.normal) < 0.0 {
            let start = difference(site.ray_origin(out), place);
            let inside = start.cross(wire.axis()).length() / wire.axis().length();
            assert!(inside < f64::from(wire.radii[0]), "{site:?} {out}: {inside}");
        }
    }
}
