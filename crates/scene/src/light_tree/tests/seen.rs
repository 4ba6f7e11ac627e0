//! Lamps of every shape, as rays from all around see them.

use super::lamps::{lamp, shapes};
use super::{point, sampler};
use crate::Light;
use crate::light_tree::LightTree;
use traylib_geometry::{Primitive, Ray, Sides};
use traylib_math::{Rgb, Sampler, Vec3, warp};

/// A place within or around a shape, from a tenth to a hundred times its size away.
fn viewpoint(sampler: &mut Sampler, shape: &Primitive) -> Vec3 {
    let bounds = shape.bounds();
    let away = 0.1 * 1000_f32.powf(sampler.next_1d()) * bounds.extent().length();
    bounds.centre() + away * warp::uniform_sphere(sampler.next_2d())
}

/// Whether a ray toward a point of the front arrives at a front.
fn is_seen_to_shine(sampler: &mut Sampler, shape: &Primitive, from: Vec3) -> bool {
    let toward = shape.sample_area(sampler.next_2d()).position - from;
    shape.intersect(&Ray::new(from, toward.normalize()), Sides::Front).is_some()
}

/// A chance of zero would lose what a ray finds.
#[test]
fn what_is_seen_to_shine_has_a_chance() {
    let mut sampler = sampler(300);
    for round in 0..300 {
        // Without a rival there is no choice.
        let rival = lamp(&mut sampler, round, 1.0);
        for primitive in shapes(&mut sampler, 1.0) {
            let lamp = Light::Area { primitive, radiance: Rgb::WHITE };
            let tree = LightTree::new(&[rival.clone(), lamp]);
            let mut shining = 0;
            for _ in 0..64 {
                let x1 = viewpoint(&mut sampler, &primitive);
                if is_seen_to_shine(&mut sampler, &primitive, x1) {
                    shining += 1;
                    assert!(tree.probability(1, x1) > 0.0, "{primitive:?} from {x1}");
                }
            }
            // Flat lamps shine into half of the space; others may take a look through an end.
            assert!(shining > 0, "{primitive:?}");
        }
    }
}

/// Together in one tree, some 10³⁶ times as bright as others.
#[test]
fn what_is_seen_to_shine_among_many_has_a_chance() {
    let mut sampler = sampler(301);
    let primitives: Vec<_> = (0..40).flat_map(|_| shapes(&mut sampler, 1.0)).collect();
    let lamp = |&primitive| {
        let radiance = Rgb::splat(2_f32.powf(120.0 * sampler.next_1d() - 60.0));
        Light::Area { primitive, radiance }
    };
    let tree = LightTree::new(&primitives.iter().map(lamp).collect::<Vec<_>>());
    let mut sampler = super::sampler(302);
    for (id, primitive) in (0..).zip(&primitives) {
        for i in 0..64 {
            let near = viewpoint(&mut sampler, primitive);
            let x1 = if i % 2 == 0 { near } else { point(&mut sampler, 12.0) };
            if is_seen_to_shine(&mut sampler, primitive, x1) {
                assert!(tree.probability(id, x1) > 0.0, "{primitive:?} from {x1}");
            }
        }
    }
}
