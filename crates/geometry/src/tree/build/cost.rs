//! What a ray pays for boxes and leaves, in units of a node.

use crate::tree::node::{LEAF, WIDTH};

/// A block of triangles.
const BLOCK: f32 = 0.6;

/// Each shape that is not a triangle of a block.
const SHAPE: f32 = 0.5;

/// The least cost for 1, 2, …, 7 places.
pub(super) type Costs = [f32; WIDTH - 1];

/// What items are; only like goes with like into a leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Triangles,
    Others,
    Mixed,
}

/// What has to be known of a subtree to put it below something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Summary {
    pub(super) count: u32,
    pub(super) costs: Costs,
    kind: Kind,
}

impl Summary {
    pub(super) fn of_item(area: f32, kind: Kind) -> Self {
        Self { count: 1, costs: of_item(area, kind), kind }
    }

    /// Of two subtrees under a box of this area; and whether they had best become
    /// one leaf.
    pub(super) fn of_node(area: f32, a: &Self, b: &Self) -> (Self, bool) {
        let kind = if a.kind == b.kind { a.kind } else { Kind::Mixed };
        let count = a.count + b.count;
        let node = area + shared(&a.costs, &b.costs, WIDTH).0;
        let leaf = leaf(area, kind, count as usize).filter(|&leaf| leaf <= node);
        let mut costs = [leaf.unwrap_or(node); WIDTH - 1];
        for places in 2..WIDTH {
            costs[places - 1] = shared(&a.costs, &b.costs, places).0.min(costs[places - 2]);
        }
        (Self { count, costs, kind }, leaf.is_some())
    }
}

pub(super) fn of_item(area: f32, kind: Kind) -> Costs {
    [leaf(area, kind, 1).unwrap_or(f32::INFINITY); WIDTH - 1]
}

/// Of a leaf, if there may be one.
fn leaf(area: f32, kind: Kind, count: usize) -> Option<f32> {
    match kind {
        _ if count > LEAF => None,
        Kind::Triangles => Some(area * BLOCK),
        Kind::Others => Some(area * SHAPE * count as f32),
        Kind::Mixed => None,
    }
}

/// The least cost of two subtrees that share 2 to 8 places, and how many of these
/// the first one gets.
pub(super) fn shared(a: &Costs, b: &Costs, places: usize) -> (f32, usize) {
    let mut best = (a[0] + b[places - 2], 1);
    for first in 2..places {
        let cost = a[first - 1] + b[places - first - 1];
        if cost < best.0 {
            best = (cost, first);
        }
    }
    best
}
