//! Trees of all sizes and shapes: nothing is lost, nothing sticks out, nothing
//! gets too deep.

mod audit;
mod hostile;
mod quality;

use super::{Quality, Tree, build};
use crate::testing::Random;
use crate::tree::node::BlockKind;
use crate::{Aabb, Vec3};
use audit::check;

const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Balanced, Quality::Best];

/// Small boxes, most of them near each other.
fn crowd(count: usize) -> Vec<Aabb> {
    let mut random = Random::new(7);
    let mut place = Vec3::ZERO;
    let mut next = |_| {
        let jump = random.number();
        place = if jump < 0.05 { 100.0 * random.point() } else { place + random.point() };
        let size = random.magnitude(0.01) * random.point().abs();
        Aabb { min: place, max: place + size }
    };
    (0..count).map(&mut next).collect()
}

/// The kind of the blocks that shapes belong into: triangles.
const TRIANGLES: fn(u32) -> Option<BlockKind> = |_| Some(BlockKind::Triangles);

/// All boxes, of triangles.
fn tree(boxes: &[Aabb], quality: Quality) -> Tree {
    build(boxes.to_vec(), (0..boxes.len() as u32).collect(), TRIANGLES, quality)
}

#[test]
fn every_item_is_in_one_leaf_and_in_the_boxes_above() {
    for count in [0, 1, 2, 3, 4, 5, 8, 9, 33, 1000] {
        let boxes = crowd(count);
        for quality in QUALITIES {
            let tree = tree(&boxes, quality);
            assert_eq!(check(&tree, &boxes, TRIANGLES), (0..count as u32).collect::<Vec<_>>());
            assert!(tree.shapes.is_empty());
        }
    }
}

#[test]
fn kinds_do_not_mix_in_leaves() {
    let kind = |i: u32| BlockKind::ALL.get((i / 3 % 7) as usize).copied();
    for count in [2, 5, 33, 1000] {
        let boxes = crowd(count);
        for quality in QUALITIES {
            let items: Vec<u32> = (0..count as u32).collect();
            let tree = build(boxes.clone(), items.clone(), kind, quality);
            assert_eq!(check(&tree, &boxes, kind), items);
        }
    }
}

#[test]
fn shapes_alone_give_no_blocks_but_the_empty_one() {
    let boxes = crowd(100);
    let tree = build(boxes.clone(), (0..100).collect(), |_| None, Quality::Balanced);
    assert_eq!(check(&tree, &boxes, |_| None), (0..100).collect::<Vec<_>>());
    assert_eq!(tree.blocks, [vec![[u32::MAX; 4]], vec![], vec![], vec![]]);
}

#[test]
fn boxes_that_are_not_asked_for_stay_out() {
    let boxes = crowd(500);
    let items: Vec<u32> = (0..500).filter(|i| i % 3 == 1).collect();
    let tree = build(boxes.clone(), items.clone(), TRIANGLES, Quality::Balanced);
    assert_eq!(check(&tree, &boxes, TRIANGLES), items);
}

/// Returns all that has to be the same for two trees to be the same.
fn content(tree: &Tree) -> impl PartialEq + use<> {
    let nodes: Vec<_> =
        tree.nodes.iter().map(|n| (n.planes.map(|p| p.map(f32::to_bits)), n.children)).collect();
    (nodes, tree.blocks.clone(), tree.shapes.clone(), tree.root, tree.depth)
}

/// The tree as built by some threads.
#[cfg(feature = "rayon")]
fn by_threads(threads: usize, boxes: &[Aabb], quality: Quality) -> Tree {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let items = (0..boxes.len() as u32).collect();
    pool.install(|| {
        build(boxes.to_vec(), items, |i| BlockKind::ALL.get((i % 5) as usize).copied(), quality)
    })
}

/// One thread takes the same way as all do without the feature.
#[test]
#[cfg(feature = "rayon")]
fn any_number_of_threads_builds_the_same_tree() {
    let boxes = crowd(30_000);
    for quality in [Quality::Fast, Quality::Balanced] {
        let one = content(&by_threads(1, &boxes, quality));
        for threads in [2, 8] {
            assert!(content(&by_threads(threads, &boxes, quality)) == one, "{threads} threads");
        }
    }
}

#[test]
fn scaling_by_powers_of_two_changes_no_choice() {
    let boxes = crowd(2000);
    for quality in QUALITIES {
        let tree = tree(&boxes, quality);
        for scale in [0.5_f32.powi(20), 4.0, 2.0_f32.powi(30)] {
            let scaled: Vec<Aabb> =
                boxes.iter().map(|b| Aabb { min: scale * b.min, max: scale * b.max }).collect();
            let scaled = self::tree(&scaled, quality);
            assert_eq!((&scaled.blocks, scaled.root), (&tree.blocks, tree.root));
            for (a, b) in scaled.nodes.iter().zip(&tree.nodes) {
                assert_eq!(a.children, b.children);
                assert_eq!(a.planes, b.planes.map(|p| p.map(|x| scale * x)));
            }
        }
    }
}
