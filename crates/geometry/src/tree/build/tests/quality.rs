//! The cost of trees of each quality, as rays would pay it.

use super::audit::boxes;
use super::{QUALITIES, crowd, tree};
use crate::Aabb;
use crate::tree::build::cost::Kind;
use crate::tree::build::{Tree, cluster, morton, wide};
use crate::tree::node::{BlockKind, Child, Content};

/// Nodes and blocks that a random ray through the whole meets on average, a block
/// counted as 0.6 nodes.
fn cost(tree: &Tree) -> f64 {
    let all = tree
        .nodes
        .first()
        .map_or(Aabb::EMPTY, |root| boxes(root).fold(Aabb::EMPTY, |all, child| all.union(child.0)));
    let weigh = |(bounds, child): (Aabb, Child)| {
        let weight = if matches!(child.open(), Content::Node(_)) { 1.0 } else { 0.6 };
        weight * f64::from(bounds.surface_area())
    };
    let sum: f64 = tree.nodes.iter().flat_map(boxes).map(weigh).sum();
    1.0 + sum / f64::from(all.surface_area())
}

/// Over all sizes: what is made small are boxes of the binary tree, of which only
/// some become boxes of nodes, so a single tree may lose a little.
#[test]
fn more_work_makes_better_trees() {
    let crowds = [50, 500, 5000].map(crowd);
    let total = |quality| crowds.iter().map(|boxes| cost(&tree(boxes, quality))).sum::<f64>();
    let [fast, balanced, best] = QUALITIES.map(total);
    assert!(balanced < fast && best < balanced, "{fast} {balanced} {best}");
}

#[test]
fn all_trees_are_better_than_halving() {
    let boxes = crowd(5000);
    let items: Vec<u32> = (0..5000).collect();
    let order = morton::order(&boxes, &items);
    let binary = cluster::tree(order.len(), |i| boxes[order[i] as usize].into(), 0);
    let halved =
        wide::tree(&binary, |node| (order[node as usize], Kind::Block(BlockKind::Triangles)));
    let [fast, balanced, _] = QUALITIES.map(|quality| cost(&tree(&boxes, quality)));
    assert!(fast < 0.8 * cost(&halved), "{fast} against {}", cost(&halved));
    assert!(balanced < 0.75 * cost(&halved), "{balanced} against {}", cost(&halved));
}
