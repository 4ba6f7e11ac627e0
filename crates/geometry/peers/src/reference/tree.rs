//! A binary tree of boxes, cut in the middle.

use glam::DVec3;

/// A box, and what lies in it; the first of two children comes next in the list.
pub(super) struct Node {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
    pub(super) content: Content,
}

pub(super) enum Content {
    Leaf { first: usize, count: usize },
    Children { second: usize },
}

type Triangle = ([DVec3; 3], u32);

const LEAF: usize = 4;

/// Sorts the triangles into leaves.
pub(super) fn build(triangles: &mut [Triangle]) -> Vec<Node> {
    let mut nodes = Vec::new();
    if !triangles.is_empty() {
        add(triangles, 0, &mut nodes);
    }
    nodes
}

fn add(triangles: &mut [Triangle], first: usize, nodes: &mut Vec<Node>) {
    let (low, high) = bounds(triangles.iter().flat_map(|t| t.0));
    let count = triangles.len();
    let index = nodes.len();
    nodes.push(Node { low, high, content: Content::Leaf { first, count } });
    if count <= LEAF {
        return;
    }
    let half = split(triangles);
    let (left, right) = triangles.split_at_mut(half);
    add(left, first, nodes);
    let second = nodes.len();
    add(right, first + half, nodes);
    nodes[index].content = Content::Children { second };
}

/// Sorts by the middles of the triangles along their longest axis, into halves.
fn split(triangles: &mut [Triangle]) -> usize {
    let middle = |t: &Triangle| t.0[0] + t.0[1] + t.0[2];
    let (low, high) = bounds(triangles.iter().map(middle));
    let axis = (high - low).max_position();
    let half = triangles.len() / 2;
    triangles.select_nth_unstable_by(half, |a, b| middle(a)[axis].total_cmp(&middle(b)[axis]));
    half
}

fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.fold(empty, |(low, high), p| (low.min(p), high.max(p)))
}
