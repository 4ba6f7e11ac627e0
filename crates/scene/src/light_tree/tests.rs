//! Choices among lamps of all kinds: what they sum to, how often each comes, and
//! that no lamp that shines at a point is left out.

mod lamps;
mod seen;

use super::shares::{BELOW_ONE, RAREST};
use super::*;
use crate::{Emission, LightPoint, PointLight, SpotCone};
use lamps::{lamp, lamps};
use traylib_geometry::{Disk, Facing, Primitive, Sphere};
use traylib_math::{Rgb, Sampler, Vec2};

/// Each level rounds a chance, made of a sum and a quotient, and a product.
const ROUNDING: f64 = 64.0 * 3.0 * f32::EPSILON as f64 / 2.0;

fn sampler(index: u64) -> Sampler {
    Sampler::numbered(21, index)
}

/// A point of the cube |x|, |y|, |z| ≤ `half`.
fn point(sampler: &mut Sampler, half: f32) -> Vec3 {
    let (xy, z) = (sampler.next_2d(), sampler.next_1d());
    (2.0 * xy.extend(z) - 1.0) * half
}

fn probabilities(tree: &LightTree, x1: Vec3) -> Vec<f32> {
    (0..tree.paths.len() as u32).map(|lamp| tree.probability(lamp, x1)).collect()
}

/// Returns the number of children that are lamps, if every child is reached once.
fn links_to_lamps(tree: &LightTree) -> usize {
    let children = tree.nodes.iter().map(|node| node.exists().bitmask().count_ones() as usize);
    // All nodes but the root are children of others; one lamp needs no node.
    1 + children.sum::<usize>() - tree.nodes.len()
}

/// Lamps that a tree has trouble with.
fn awkward() -> Vec<Vec<Light>> {
    let point =
        |position: Vec3| Light::Point(PointLight { position, intensity: Rgb::WHITE, cone: None });
    let row = |step: f32| (0..300_u16).map(|i| point(Vec3::X * step * f32::from(i))).collect();
    // Every plane leaves one lamp on a side, in which the levels run out.
    let steep = (0..120_u8).map(|i| point(Vec3::Y * f32::from(i) - Vec3::X * 2_f32.powi(i.into())));
    let huge = |i: u8| point(Vec3::splat(1e38) * (f32::from(i) - 4.0));
    vec![row(0.0), row(1.0), row(1e-30), steep.collect(), (0..9).map(huge).collect()]
}

#[test]
fn chances_sum_to_one() {
    let many = [1, 2, 3, 10, 700].map(|count| lamps(count, count as u64, 1.0));
    let mut sampler = sampler(0);
    for lights in many.into_iter().chain(awkward()) {
        let tree = LightTree::new(&lights);
        assert_eq!(links_to_lamps(&tree), lights.len());
        for size in [1e-3, 1.0, 12.0, 1e4, 1e30] {
            let x1 = point(&mut sampler, size);
            let sum: f64 = probabilities(&tree, x1).into_iter().map(f64::from).sum();
            assert!((sum - 1.0).abs() < ROUNDING, "{} lamps, {x1}: {sum}", lights.len());
        }
    }
}

/// u runs through 2¹⁸ even steps, of which each lamp owns an interval; rounding
/// moves its two ends by less than a step.
#[test]
fn lamps_come_as_often_as_they_say() {
    const STEPS: u32 = 1 << 18;
    for count in [1, 2, 5, 300] {
        let tree = LightTree::new(&lamps(count, 7, 1.0));
        let x1 = point(&mut sampler(8), 10.0);
        let mut found = vec![0_u32; count];
        for step in 0..STEPS {
            let (lamp, probability) = tree.choose(x1, (f64::from(step) + 0.5) / f64::from(STEPS));
            assert_eq!(probability.to_bits(), tree.probability(lamp, x1).to_bits());
            found[lamp as usize] += 1;
        }
        for (lamp, (found, probability)) in found.iter().zip(probabilities(&tree, x1)).enumerate() {
            let known = f64::from(probability) * f64::from(STEPS);
            assert!((f64::from(*found) - known).abs() < 2.0, "{lamp}: {found}, not {known}");
        }
    }
}

#[test]
fn a_single_lamp_is_certain() {
    for kind in 0..18 {
        let tree = LightTree::new(&[lamp(&mut sampler(9), kind, 1.0)]);
        for u in [0.0, 0.3, BELOW_ONE] {
            assert_eq!(tree.choose(Vec3::ONE, u), (0, 1.0));
        }
        assert_eq!(tree.probability(0, Vec3::NAN), 1.0);
    }
}

/// Returns a place from which a point of this lamp may be seen: anywhere, or hardly off its plane.
fn place(sampler: &mut Sampler, from: &LightPoint) -> Vec3 {
    let away = point(sampler, 10.0);
    let normal = from.site.normal;
    let grazing = away - normal * normal.dot(away) * (1.0 - 1e-5 * sampler.next_1d());
    let far = 100_f32.powf(4.0 * sampler.next_1d() - 2.0);
    from.site.position + far * if sampler.next_1d() < 0.5 { away } else { grazing }
}

/// A chance of zero would lose light.
#[test]
fn a_lamp_that_shines_at_a_point_has_a_chance() {
    let mut shining = 0;
    for seed in 0..40 {
        let lights = lamps(140, 100 + seed, 1.0);
        let tree = LightTree::new(&lights);
        let mut sampler = sampler(200 + seed);
        for (id, light) in (0..).zip(&lights) {
            for _ in 0..20 {
                let Emission { point, .. } = light.sample_emission(sampler.next_2d(), Vec2::ZERO);
                let x1 = place(&mut sampler, &point);
                let direction = (x1 - point.site.position).normalize();
                if point.falloff(direction) > 0.0 {
                    shining += 1;
                    assert!(tree.probability(id, x1) > 0.0, "{light:?} at {x1}");
                }
            }
        }
    }
    assert!(shining > 40_000, "{shining}");
}

/// Nothing is known of a lamp where squares leave single precision.
#[test]
fn a_lamp_that_shines_from_afar_has_a_chance() {
    let away = Vec3::new(1.0, 0.0, 1.0).normalize();
    for far in [1e10, 1e18, 1e19, 3e19, 1e20] {
        let disk = Disk::new(Vec3::X * far, -away, 0.01 * far).unwrap();
        let ball = Sphere::new(Vec3::Y, 0.5, Facing::Outward).unwrap();
        let primitives = [Primitive::Disk(disk), Primitive::Sphere(ball)];
        let lights = primitives.map(|primitive| Light::Area { primitive, radiance: Rgb::WHITE });
        let x1 = Vec3::new(3.0, -2.0, 1.0);
        assert!(LightTree::new(&lights).probability(0, x1) > 0.0, "{far}");
    }
}

/// Lamps that face away have none, if any other can do better.
#[test]
fn a_lamp_that_shines_elsewhere_is_left_out() {
    let disk = |at: Vec3, normal| Light::Area {
        primitive: Primitive::Disk(Disk::new(at, normal, 0.1).unwrap()),
        radiance: Rgb::WHITE,
    };
    let spot = |axis| {
        let cone = Some(SpotCone::new(axis, 0.9, 0.8).unwrap());
        Light::Point(PointLight { position: Vec3::Z, intensity: Rgb::WHITE, cone })
    };
    let [down, up] = [Vec3::NEG_Z, Vec3::Z];
    let lights = [disk(Vec3::Z, down), disk(Vec3::Z, up), spot(Vec3::X), spot(down)];
    let found = probabilities(&LightTree::new(&lights), Vec3::ZERO);
    assert!(found[0] > 0.0 && found[3] > 0.0, "{found:?}");
    assert_eq!(found[1..3], [0.0; 2]);
}

/// The nearer of two equal lamps comes more often, by the square of the distances.
#[test]
fn nearness_counts_with_the_square() {
    let point = |x| {
        let position = Vec3::X * x;
        Light::Point(PointLight { position, intensity: Rgb::WHITE, cone: None })
    };
    let tree = LightTree::new(&[point(-1.0), point(3.0)]);
    let found = probabilities(&tree, Vec3::ZERO);
    assert!((found[0] - 0.9).abs() < 2.0 * f32::EPSILON, "{found:?}");
}

/// Of two lamps that shine, none is rarer than the floor, however weak or far, and
/// the step of `u` that is the last finds it.
#[test]
fn a_lamp_that_is_outshone_has_the_least_chance() {
    let point = |x: f32, strength| {
        let position = Vec3::X * x;
        Light::Point(PointLight { position, intensity: Rgb::splat(strength), cone: None })
    };
    for (x, strength) in [(1.0, 1e-6), (1.0, 1e-38), (1e15, 1.0), (1e25, 1e-30)] {
        let tree = LightTree::new(&[point(-1.0, 1.0), point(x, strength)]);
        // The other's share is short of one by the little that the lamp may give.
        let rarest = RAREST / (1.0 + RAREST);
        let (lamp, chance) = tree.choose(Vec3::ZERO, 1.0 - 2_f64.powi(-32));
        assert_eq!(lamp, 1);
        assert!((rarest..rarest * (1.0 + 2e-6)).contains(&chance), "{chance}");
        assert_eq!(probabilities(&tree, Vec3::ZERO), [1.0 - chance, chance]);
    }
}

/// Each of a row of lamps outshines all before it, so that the way to the first is
/// one of many floors.
#[test]
fn a_lamp_that_many_outshine_has_a_chance() {
    let lamp = |i: i32| {
        let at = 2_f32.powi(2 * i - 60);
        let intensity = Rgb::splat(2_f32.powi(4 * i - 120));
        Light::Point(PointLight { position: Vec3::X * at, intensity, cone: None })
    };
    let lights: Vec<Light> = (0..60).map(lamp).collect();
    let tree = LightTree::new(&lights);
    for i in -70..70 {
        let found = probabilities(&tree, Vec3::new(0.0, 2_f32.powi(i), 0.0));
        assert!(found.iter().all(|&chance| chance > 0.0), "{found:?}");
    }
}

/// As deep as trees get.
#[test]
fn no_number_of_floors_makes_a_zero() {
    assert!((0..32).fold(1.0, |chance, _| both(chance, RAREST)) > 0.0);
    assert_eq!(both(both(RAREST, 0.0), 1.0), 0.0);
}

#[test]
fn scale_leaves_every_bit() {
    let [small, plain, large] = [-14, 0, 20].map(|power| {
        let scale = 2_f32.powi(power);
        let tree = LightTree::new(&lamps(300, 11, scale));
        let mut sampler = sampler(12);
        let mut choices = Vec::new();
        for _ in 0..2000 {
            let x1 = point(&mut sampler, 12.0) * scale;
            let (lamp, probability) = tree.choose(x1, sampler.next_fine());
            choices.push((lamp, probability.to_bits()));
        }
        (tree.paths, choices)
    });
    assert!(small == plain && plain == large);
}

/// As many lamps as a city has; each of a hundred choices is a way of some ten levels.
#[test]
fn a_hundred_thousand_lamps() {
    let lights = lamps(100_000, 13, 1.0);
    let tree = LightTree::new(&lights);
    let mut sampler = sampler(14);
    for _ in 0..100 {
        let x1 = point(&mut sampler, 10.0);
        let (lamp, probability) = tree.choose(x1, sampler.next_fine());
        let mut levels = 0;
        let path = tree.paths[lamp as usize];
        let again = tree.descend(x1, |level, _| {
            levels = level + 1;
            turn_of(path, level)
        });
        assert_eq!(again, (lamp, probability));
        assert!((5..20).contains(&levels), "{levels}");
    }
}
