//! Areas, samples and bounds.

use super::*;
use crate::{Disk, Primitive};
use traylib_math::warp;

const CELLS: usize = 16;

/// Chi-square of 100 000 points of the unit square in 16 × 16 cells, of
/// which a uniform source exceeds 347.7 once in 10 000 times (255 degrees of
/// freedom).
fn chi_square(mut point: impl FnMut() -> [f64; 2]) -> f64 {
    const POINTS: u32 = 100_000;
    let mut counts = [[0_u32; CELLS]; CELLS];
    let cell = |x: f64| ((x * CELLS as f64) as usize).min(CELLS - 1);
    for _ in 0..POINTS {
        let [x, y] = point();
        counts[cell(x)][cell(y)] += 1;
    }
    let expected = f64::from(POINTS) / (CELLS * CELLS) as f64;
    counts.iter().flatten().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum()
}

fn turn(x: f64, y: f64) -> f64 {
    y.atan2(x).rem_euclid(TAU) / TAU
}

#[test]
fn equal_areas_of_a_cone_get_equally_many_samples() {
    let mut random = Random::new(1);
    let ends = [Vec3::new(1.0, -2.0, 0.5), Vec3::new(0.0, 1.0, 0.75)];
    for radii in [[0.5, 0.5], [0.0, 2.0], [1.0, 0.0], [3.0, 1.0], [0.999, 1.0]] {
        let cone = cone(ends, radii);
        let axis = cone.axis();
        let (x, y) = axis.normalize().any_orthonormal_pair();
        let found = chi_square(|| {
            let site = cone.sample_area(random.square());
            let from_end = difference(site.position, ends[0]);
            let height = from_end.dot(axis) / axis.length_squared();
            // The area up to there: mean radius times height.
            let up_to = |h: f64| h * (f64::from(radii[0]) + 0.5 * h * cone.widening());
            [up_to(height) / up_to(1.0), turn(from_end.dot(x), from_end.dot(y))]
        });
        assert!(found < 347.7, "{radii:?}: {found}");
    }
}

#[test]
fn equal_areas_of_a_ring_get_equally_many_samples() {
    let mut random = Random::new(2);
    for inner in [0.0, 1.0, 1.9, 1.999] {
        let ring = Disk::ring(Vec3::ZERO, Vec3::Z, inner, 2.0).unwrap();
        let hole = f64::from(inner).powi(2);
        let found = chi_square(|| {
            let at = ring.sample_area(random.square()).position.as_dvec3();
            [(at.length_squared() - hole) / (4.0 - hole), turn(at.x, at.y)]
        });
        assert!(found < 347.7, "{inner}: {found}");
    }
}

/// A line uniform among those that meet the ball of radius `reach`.
fn any_line(reach: f32, random: &mut Random) -> Ray {
    let direction = random.direction();
    let (x, y) = direction.any_orthonormal_pair();
    let aside = reach * warp::uniform_disk(random.square());
    Ray::new(aside.x * x + aside.y * y - 2.0 * reach * direction, direction)
}

/// Crofton: of the lines through a ball of radius R, a surface within is
/// crossed by A/(2πR²) on average. Both crossings of a convex surface are found
/// by asking for its outside and for its inside.
#[test]
fn areas_are_those_that_lines_meet() {
    const LINES: u32 = 100_000;
    let mut random = Random::new(3);
    let ends = [Vec3::new(0.2, -0.7, 0.1), Vec3::new(-0.1, 0.4, 0.3)];
    let tubes = [[0.3, 0.3], [0.0, 0.4], [0.5, 0.1]].map(|radii| {
        [Facing::Outward, Facing::Inward]
            .map(|facing| Primitive::Cone(Cone::new(ends, radii, facing).unwrap()))
    });
    let rings = [0.0, 0.5, 0.9].map(|inner| {
        [Vec3::ONE, -Vec3::ONE]
            .map(|up| Primitive::Disk(Disk::ring(Vec3::ZERO, up, inner, 1.0).unwrap()))
    });
    for both in tubes.into_iter().chain(rings) {
        let mut crossings = 0;
        for _ in 0..LINES {
            let line = any_line(1.0, &mut random);
            let met = |s: &&Primitive| s.intersect(&line, Sides::Front).is_some();
            crossings += both.iter().filter(met).count();
        }
        let mean = crossings as f64 / f64::from(LINES);
        let expected = f64::from(both[0].area()) / TAU;
        // No line crosses more than twice: the variance is at most twice the
        // mean. Four and a half standard errors: once in 150 000 times.
        let allowed = 4.5 * (2.0 * expected / f64::from(LINES)).sqrt();
        assert!((mean - expected).abs() < allowed, "{both:?}: {mean} {expected}");
    }
}

/// All points lie in the bounds, before they are rounded too (rounding moves
/// none beyond a bound that is an f32); and each bound is touched.
#[test]
fn bounds_are_tight() {
    let mut random = Random::new(4);
    for _ in 0..2000 {
        let cone = any_cone(&mut random);
        let (bounds, (x, y)) = (cone.bounds(), cone.axis().normalize().any_orthonormal_pair());
        let mut touched = Aabb::EMPTY;
        for i in 0..256 {
            let (sin, cos) = (TAU * f64::from(i) / 256.0).sin_cos();
            for height in [0.0, 0.5, 1.0] {
                let radius = f64::from(cone.radii[0]) + height * cone.widening();
                let from_end = height * cone.axis() + radius * (x * cos + y * sin);
                let point = cone.ends[0].as_dvec3() + from_end;
                let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
                assert!(min.cmple(point).all() && point.cmple(max).all(), "{cone:?}: {point}");
                touched = touched.extend(point.as_vec3());
            }
        }
        // A rim between two of 256 points bulges by r(1 − cos(π/256)).
        let bulge = 1e-4 * cone.radii[0].max(cone.radii[1]);
        let rounding = bounds.min.abs().max(bounds.max.abs()) * (4.0 * f32::EPSILON);
        let grown = touched.grown(rounding + bulge);
        assert!(grown.contains(bounds.min) && grown.contains(bounds.max), "{cone:?}");
    }
}
