//! Crossings against those found by walking along the ray.

use super::*;

/// A change of sides on the way along a ray.
struct Change {
    t: f64,
    /// From outside to inside.
    enters: bool,
}

/// Returns how far a point of the ray is from the axis beyond the radius there.
fn beyond(cone: &Cone, ray: &Ray, t: f64) -> f64 {
    let axis = cone.axis();
    let from_end = difference(ray.origin, cone.ends[0]) + t * ray.direction.as_dvec3();
    let height = from_end.dot(axis) / axis.length_squared();
    let radius = f64::from(cone.radii[0]) + height * cone.widening();
    (from_end - height * axis).length() - radius
}

/// The times at which the ray is between the ends; `None` if never, and for a ray
/// exactly across the axis, which none is by chance.
fn between_ends(cone: &Cone, ray: &Ray) -> Option<(f64, f64)> {
    let axis = cone.axis();
    let speed = ray.direction.as_dvec3().dot(axis);
    let at = |end: usize| difference(cone.ends[end], ray.origin).dot(axis) / speed;
    let (from, to) = (at(0).min(at(1)).max(0.0), at(0).max(at(1)));
    (from < to && to.is_finite()).then_some((from, to))
}

/// The changes of sides between the ends that a walk in 200 steps notices, each
/// found by bisection.
fn changes(cone: &Cone, ray: &Ray) -> Vec<Change> {
    let Some((from, to)) = between_ends(cone, ray) else { return Vec::new() };
    let at = |i: u32| from + (to - from) * (f64::from(i) / 200.0);
    let outside = |t: f64| beyond(cone, ray, t) > 0.0;
    let steps = (0..200).map(|i| (at(i), at(i + 1)));
    let found = steps.filter(|&(a, b)| outside(a) != outside(b));
    found
        .map(|(mut a, mut b)| {
            let enters = outside(a);
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                if outside(middle) == enters { a = middle } else { b = middle }
            }
            Change { t: 0.5 * (a + b), enters }
        })
        .collect()
}

/// A ray to the surface or near it, from near or far.
fn some_ray(cone: &Cone, random: &mut Random) -> Ray {
    let target = cone.sample_area(random.square()).position;
    let size = cone.slant_squared().sqrt() as f32 + cone.radii[0].max(cone.radii[1]);
    let aside = size * random.magnitude(1e-3) * random.point();
    let origin = target + size * random.magnitude(1e2) * random.point();
    Ray::new(origin, random.magnitude(1e3) * (target + aside - origin))
}

/// A surface that the walk notices is hit, there or earlier; and every hit is on the surface,
/// crossed in an admitted direction.
#[test]
fn hits_are_what_a_walk_along_the_ray_finds() {
    let mut random = Random::new(1);
    let mut met = 0;
    for i in 0..30_000 {
        let scale = [2.0_f32.powi(-14), 1.0, 2.0_f32.powi(20)][i % 3];
        let original = any_cone(&mut random);
        let (ends, radii) = (original.ends.map(|p| p * scale), original.radii.map(|r| r * scale));
        let cone = Cone::new(ends, radii, original.facing).unwrap();
        let ray = some_ray(&cone, &mut random);
        let found = changes(&cone, &ray);
        for sides in [Sides::Both, Sides::Front] {
            let hit = cone.intersect(&ray, sides).map(|hit| f64::from(hit.t));
            met += usize::from(hit.is_some());
            check_hit(&cone, &ray, sides, hit);
            let admitted = |c: &&Change| is_admitted(&cone, sides, c.enters);
            if let Some(first) = found.iter().find(admitted) {
                // Half a unit in the last place of f32, and the walk's rounding.
                let latest = first.t * (1.0 + 2.0_f64.powi(-23));
                assert!(hit.is_some_and(|t| t <= latest), "{cone:?} {ray:?} {sides:?}: {hit:?}");
            }
        }
    }
    // More than half of all.
    assert!(met > 30_000, "{met}");
}

fn is_admitted(cone: &Cone, sides: Sides, enters: bool) -> bool {
    sides == Sides::Both || enters == (cone.facing == Facing::Outward)
}

/// A hit lies between the ends and on the surface, to the rounding of its t,
/// and on its two sides the ray is where the crossing says.
fn check_hit(cone: &Cone, ray: &Ray, sides: Sides, hit: Option<f64>) {
    let Some(t) = hit else { return };
    let rounding = t * 2.0_f64.powi(-23);
    let (from, to) = between_ends(cone, ray).unwrap();
    assert!(from - rounding <= t && t <= to + rounding, "{cone:?} {ray:?}: {t}");
    let allowed = rounding * ray.direction.as_dvec3().length();
    // The radius itself changes by so much on the way, and the walk rounds.
    let steep = 1.0 + cone.widening().abs() / cone.axis().length();
    let off = beyond(cone, ray, t).abs();
    assert!(off <= 2.0 * allowed * steep, "{cone:?} {ray:?}: {off}");
    let (before, after) = (beyond(cone, ray, t - rounding), beyond(cone, ray, t + rounding));
    // A ray that grazes may be on one side both times.
    if (before > 0.0) != (after > 0.0) {
        assert!(is_admitted(cone, sides, before > 0.0), "{cone:?} {ray:?} {sides:?}");
    }
}
