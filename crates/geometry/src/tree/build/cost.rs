//! The cost that boxes and leaves have for a ray, in units of a node.

use crate::tree::node::{BlockKind, LEAF, WIDTH};

/// A block of triangles.
const TRIANGLES: f32 = 0.6;

/// A block of shapes of another kind, and each shape in it: what is in large boxes had better
/// be alone.
const BLOCK: f32 = 0.3;
const IN_BLOCK: f32 = 0.2;

/// Each shape that is in no block.
const SHAPE: f32 = 0.5;

/// The least cost for 1, 2, …, 7 places.
pub(super) type Costs = [f32; WIDTH - 1];

/// The kind of an item; only like goes with like into a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Block(BlockKind),
    Others,
    Mixed,
}

/// A summary of a subtree: what has to be known to put it below something.
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

    /// Computes the cost of two subtrees under a box of this area; and whether they had best become
    /// one leaf.
    pub(super) fn of_node(area: f32, a: &Self, b: &Self) -> (Self, bool) {
        let kind = if a.kind == b.kind { a.kind } else { Kind::Mixed };
        let count = a.count + b.count;
        let shared = all_shared(&a.costs, &b.costs);
        let node = area + shared[WIDTH - 2];
        let leaf = leaf(area, kind, count as usize).filter(|&leaf| leaf <= node);
        let mut costs = [leaf.unwrap_or(node); WIDTH - 1];
        for places in 2..WIDTH {
            costs[places - 1] = shared[places - 2].min(costs[places - 2]);
        }
        (Self { count, costs, kind }, leaf.is_some())
    }
}

pub(super) fn of_item(area: f32, kind: Kind) -> Costs {
    [leaf(area, kind, 1).unwrap_or(f32::INFINITY); WIDTH - 1]
}

/// Computes the cost of a leaf, if there may be one.
fn leaf(area: f32, kind: Kind, count: usize) -> Option<f32> {
    match kind {
        _ if count > LEAF => None,
        Kind::Block(BlockKind::Triangles) => Some(area * TRIANGLES),
        Kind::Block(BlockKind::Quads | BlockKind::Spheres | BlockKind::Disks) => {
            Some(area * (BLOCK + IN_BLOCK * count as f32))
        }
        Kind::Others => Some(area * SHAPE * count as f32),
        Kind::Mixed => None,
    }
}

/// The least cost of two subtrees that share 2, 3, …, 8 places.
fn all_shared(a: &Costs, b: &Costs) -> Costs {
    let mut least = [f32::INFINITY; WIDTH - 1];
    for (first, a) in a.iter().enumerate() {
        for (least, b) in least[first..].iter_mut().zip(b) {
            // In this form it is one instruction.
            *least = if a + b < *least { a + b } else { *least };
        }
    }
    least
}

/// The least cost of two subtrees that share 2 to 8 places, and how many of these
/// the first one gets; where costs are equal, about half.
pub(super) fn shared(a: &Costs, b: &Costs, places: usize) -> (f32, usize) {
    let cost = |first: usize| a[first - 1] + b[places - first - 1];
    let mut best = (cost(1), 1);
    for first in 2..places {
        let cost = cost(first);
        if cost < best.0 || (cost == best.0 && 2 * first <= places) {
            best = (cost, first);
        }
    }
    best
}
