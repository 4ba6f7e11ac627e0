//! Boxes that nobody would wish for.

use super::audit::check;
use super::{QUALITIES, TRIANGLES, tree};
use crate::testing::Random;
use crate::{Aabb, Vec3};

/// Builds and checks with all qualities; returns the depths.
fn depths(boxes: &[Aabb]) -> [usize; 3] {
    QUALITIES.map(|quality| {
        let tree = tree(boxes, quality);
        let items = check(&tree, boxes, TRIANGLES);
        assert_eq!(items, (0..boxes.len() as u32).collect::<Vec<_>>());
        tree.depth
    })
}

/// A cube of this size with its centre there.
fn cube(centre: Vec3, size: f32) -> Aabb {
    Aabb { min: centre - 0.5 * size, max: centre + 0.5 * size }
}

#[test]
fn equal_boxes_make_a_flat_tree() {
    // 1000 leave 250 blocks at best, for which three levels are enough.
    for size in [0.0, 1.0, 1e20] {
        let depths = depths(&vec![cube(Vec3::ONE, size); 1000]);
        assert!(depths.iter().all(|&depth| depth <= 6), "{depths:?}");
    }
}

#[test]
fn points_make_a_tree() {
    let mut random = Random::new(3);
    let points: Vec<Aabb> = (0..1000).map(|_| cube(random.point(), 0.0)).collect();
    let on_a_line: Vec<Aabb> = (0..1000).map(|i| cube(i as f32 * Vec3::X, 0.0)).collect();
    for boxes in [points, on_a_line] {
        assert!(depths(&boxes).iter().all(|&depth| depth <= 10));
    }
}

#[test]
fn growing_boxes_make_a_tree() {
    for (ratio, count) in [(1.5_f32, 80), (4.0, 60)] {
        let sizes: Vec<f32> = (0..count).map(|i| ratio.powi(i - count / 2)).collect();
        let around_one_point: Vec<Aabb> = sizes.iter().map(|&s| cube(Vec3::ZERO, s)).collect();
        let side_by_side: Vec<Aabb> =
            sizes.iter().map(|&s| cube(Vec3::new(3.0 * s, 0.0, 0.0), s)).collect();
        depths(&around_one_point);
        depths(&side_by_side);
    }
}

#[test]
fn an_onion_takes_few_rounds_and_levels() {
    // Each box would merge with the next smaller one.
    let boxes: Vec<Aabb> = (0..3000).map(|i| cube(Vec3::ZERO, 1.0 + i as f32 / 3000.0)).collect();
    depths(&boxes);
}

#[test]
fn boxes_all_over_each_other_make_a_tree_in_time() {
    // Any of these might be the best neighbour of any other.
    let mut random = Random::new(4);
    let boxes: Vec<Aabb> = (0..3000).map(|_| cube(0.01 * random.point(), 10.0)).collect();
    depths(&boxes);
}

#[test]
fn numbers_near_both_ends_make_a_tree() {
    let mut random = Random::new(5);
    for size in [f32::MAX / 4.0, 1e25, 1e-25, f32::MIN_POSITIVE, 1e-44] {
        let boxes: Vec<Aabb> =
            (0..500).map(|_| cube(size * random.point(), 0.1 * size * random.number())).collect();
        depths(&boxes);
    }
}
