mod gaps;

use super::*;
use crate::testing::Random;
use crate::testing::shape::{distance, on_border, scaled};
use crate::{Hit, Primitive, SurfaceSite};

fn whole(hit: ShapeHit) -> Hit {
    Hit { t: hit.t, primitive: 0, u: hit.u, v: hit.v }
}

fn bits(v: Vec3) -> [u32; 3] {
    v.to_array().map(f32::to_bits)
}

/// A ray from anywhere to a sampled point meets the shape there or before, and
/// what it meets lies in the bounds, to a few roundings of the distance.
#[test]
fn sampled_points_are_met() {
    let mut random = Random::new(1);
    for _ in 0..20_000 {
        let shape = random.primitive(Vec3::ZERO);
        let target = shape.sample_area(random.square());
        let ray = Ray::new(3.0 * random.point(), Vec3::ZERO);
        let ray = Ray { direction: 2.0 * (target.position - ray.origin), ..ray };
        // A ray along the surface or past its border may miss.
        let cosine = ray.direction.normalize().dot(target.normal);
        let Some(hit) = shape.intersect(&ray, Sides::Both) else {
            let border = on_border(&shape, &target);
            assert!(cosine.abs() < 1e-2 || border, "{shape:?} {target:?}");
            continue;
        };
        let site = shape.site(&ray, &whole(hit));
        assert!(hit.t <= 0.5 + 1e-5 / cosine.abs(), "{hit:?}");
        let apart = site.position.distance(ray.at(hit.t));
        assert!(apart < 1e-5 / cosine.abs(), "{shape:?}: {apart}");
        let bounds = shape.bounds();
        assert!(bounds.grown(site.error).contains(site.position), "{bounds:?} {site:?}");
    }
}

/// No constant with a unit of length: scaling by a power of two changes no bit.
#[test]
fn scaling_by_powers_of_two_is_exact() {
    let mut random = Random::new(2);
    for _ in 0..20_000 {
        let place = random.magnitude(1e3) * random.point();
        // Rebuilt, as the scaled ones are: unit normals are rounded again.
        let original = random.primitive(place);
        let shape = scaled(&original, 1.0);
        let target = shape.sample_area(random.square()).position;
        let origin = target + 3.0 * random.point();
        let ray = Ray::new(origin, target + 0.1 * random.point() - origin);
        for scale in [1024.0, 2.0_f32.powi(20), 2.0_f32.powi(-14)] {
            let scaled = scaled(&original, scale);
            let far_ray = Ray { origin: ray.origin * scale, ..ray };
            let (one, other) =
                (shape.intersect(&ray, Sides::Both), scaled.intersect(&far_ray, Sides::Both));
            let (Some(one), Some(other)) = (one, other) else {
                assert!(one.is_none() && other.is_none());
                continue;
            };
            assert_eq!(other.t.to_bits(), (one.t * scale).to_bits(), "{shape:?}");
            assert_eq!((other.u.to_bits(), other.v.to_bits()), (one.u.to_bits(), one.v.to_bits()));
            let site = shape.site(&ray, &whole(one));
            let far_site = scaled.site(&far_ray, &whole(other));
            assert_eq!(bits(far_site.position), bits(site.position * scale));
            assert_eq!(bits(far_site.normal), bits(site.normal));
            let out = random.direction();
            assert_eq!(bits(far_site.ray_origin(out)), bits(site.ray_origin(out) * scale));
        }
    }
}

/// Seen from the front all sides are alike; from behind, `Front` sees through.
#[test]
fn fronts_are_met_from_the_front_only() {
    let mut random = Random::new(4);
    for _ in 0..5000 {
        let shape = random.primitive(Vec3::ZERO);
        let target = shape.sample_area(random.square());
        let away = random.direction();
        let slanted = away.dot(target.normal).abs() < 0.1;
        if slanted || on_border(&shape, &target) || is_thin_at(&shape, &target) {
            continue;
        }
        let ray = Ray::new(target.position + 1e-2 * away, -away);
        let both = shape.intersect(&ray, Sides::Both).unwrap();
        assert!((both.t - 1e-2).abs() < 1e-4, "{shape:?}");
        let front = shape.intersect(&ray, Sides::Front);
        let meets_here = front.is_some_and(|hit| hit.t == both.t);
        assert_eq!(meets_here, away.dot(target.normal) > 0.0, "{shape:?}");
    }
}

/// Tells whether a point a hundredth inside of a cone may be outside again: across it, at a cosine
/// of 0.1, its surfaces are a fifth of its radius apart.
fn is_thin_at(shape: &Primitive, site: &SurfaceSite) -> bool {
    let Primitive::Cone(cone) = shape else { return false };
    let [one, other] = cone.ends();
    (site.position - one).cross((other - one).normalize()).length() < 0.06
}

#[test]
fn rays_that_are_none_miss_every_shape() {
    let mut random = Random::new(5);
    let bad = [0.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    for _ in 0..1000 {
        let shape = random.primitive(Vec3::ZERO);
        for x in bad {
            let ray = Ray::new(random.point(), Vec3::splat(x));
            assert_eq!(shape.intersect(&ray, Sides::Both), None, "{shape:?} {ray:?}");
        }
        for x in &bad[1..] {
            let ray = Ray::new(Vec3::splat(*x), random.direction());
            assert_eq!(shape.intersect(&ray, Sides::Both), None, "{shape:?} {ray:?}");
        }
    }
}

/// Points far from the origin stay within their error bound of the plane or
/// sphere they were computed for, judged in double precision.
#[test]
fn errors_are_bounded() {
    let mut random = Random::new(6);
    for _ in 0..50_000 {
        let place = random.magnitude(1e4) * random.point();
        let shape = random.sliver(place);
        let site = shape.sample_area(random.square());
        let allowed = f64::from(site.error.dot(site.normal.abs()));
        let off = distance(&shape, site.position);
        assert!(off <= allowed, "{shape:?}: {off} > {allowed}");
    }
}

#[test]
fn what_has_no_area_is_refused() {
    let (o, x, nan) = (Vec3::ZERO, Vec3::X, Vec3::new(0.0, f32::NAN, 0.0));
    assert_eq!(Triangle::new(o, x, 3.0 * x), Err(Error::NoArea));
    assert_eq!(Triangle::new(o, x, nan), Err(Error::NotFinite));
    assert_eq!(Triangle::new(o, 1e-20 * x, 1e-20 * Vec3::Y), Err(Error::NoArea));
    assert_eq!(Quad::new(o, x, x), Err(Error::NoArea));
    assert_eq!(Quad::new(f32::MAX * x, f32::MAX * x, Vec3::Y), Err(Error::NotFinite));
    assert_eq!(Disk::new(o, o, 1.0), Err(Error::NoNormal));
    assert_eq!(Disk::new(o, x, 0.0), Err(Error::NoRadius));
    assert_eq!(Disk::ring(o, x, -0.5, 1.0), Err(Error::NoRadius));
    assert_eq!(Disk::ring(o, x, f32::NAN, 1.0), Err(Error::NotFinite));
    for inner in [1.0, 2.0, f32::MAX] {
        assert_eq!(Disk::ring(o, x, inner, 1.0), Err(Error::NoArea));
    }
    assert_eq!(Sphere::new(o, -1.0, Facing::Outward), Err(Error::NoRadius));
    assert_eq!(Sphere::new(o, f32::NAN, Facing::Outward), Err(Error::NotFinite));
    assert_eq!(Sphere::new(o, 1e30, Facing::Outward), Err(Error::NoArea));
}
