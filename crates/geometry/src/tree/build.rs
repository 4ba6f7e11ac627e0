//! Building a tree.
//!
//! Items are put along a curve through space (`morton`), merged to a binary tree
//! from the leaves up (`cluster`), of which subtrees then move to better places
//! (`reinsert`); last, nodes are left out until eight boxes are side by side and
//! up to four items in a leaf (`flat`, `wide`).

mod binary;
mod bounds;
mod choice;
mod cluster;
mod cost;
mod flat;
mod morton;
mod plan;
mod reinsert;
mod search;
mod wide;

use super::node::{BlockKind, Child, LEAF, Node};
use super::parallel;
use crate::Aabb;
use cost::Kind;

/// No tree has more levels of nodes.
pub(crate) const MAX_DEPTH: usize = 32;

/// Items that a thread takes at once.
const GRAIN: usize = 1 << 12;

/// The work that goes into building a tree: the more, the less rays have to do in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Quality {
    /// In half the time of [`Balanced`](Self::Balanced); a ray meets up to an
    /// eighth more boxes. For shapes that change before many rays are cast.
    Fast,
    /// About a microsecond a shape.
    #[default]
    Balanced,
    /// Until hardly anything is gained, which takes ten to thirty times as long; a ray
    /// meets a few boxes in a hundred less. For pictures that take hours.
    Best,
}

/// Boxes in boxes, eight a node.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Depth first, in the order in which a walk meets them.
    pub(crate) nodes: Vec<Node>,
    /// The numbers of the shapes of each block, by [`BlockKind`], [`u32::MAX`] where there is none;
    /// depth first. There always is a block of triangles.
    pub(crate) blocks: [Vec<[u32; LEAF]>; 4],
    /// The numbers of all shapes that are in no block, in leaf order.
    pub(crate) shapes: Vec<u32>,
    /// A node or a leaf; `None` where there is nothing.
    pub(crate) root: Option<Child>,
    /// Levels of nodes.
    pub(crate) depth: usize,
}

/// A tree over `items`, which are numbers of boxes; boxes must be finite and not
/// empty.
///
/// The result is the same for any number of threads, and has at most
/// [`MAX_DEPTH`] levels.
pub(crate) fn build(
    boxes: Vec<Aabb>,
    items: Vec<u32>,
    block_kind: impl Fn(u32) -> Option<BlockKind> + Sync,
    quality: Quality,
) -> Tree {
    if items.is_empty() {
        let blocks = [vec![[u32::MAX; LEAF]], Vec::new(), Vec::new(), Vec::new()];
        return Tree { nodes: Vec::new(), blocks, shapes: Vec::new(), root: None, depth: 0 };
    }
    let order = morton::order(&boxes, &items);
    drop(items);
    // Asked for in any order later, when whatever they depend on is far away.
    let kinds = parallel::map(boxes.len(), GRAIN, |item| {
        block_kind(item as u32).map_or(Kind::Others, Kind::Block)
    });
    let item = |node: u32| {
        let item = order[node as usize];
        (item, kinds[item as usize])
    };
    let bounds = |i: usize| boxes[order[i] as usize].into();
    let mut binary = cluster::tree(order.len(), bounds, quality.radius());
    // The binary tree has its own, and what follows takes the most memory.
    drop(boxes);
    reinsert::improve(&mut binary, quality.candidates(order.len()));
    let tree = wide::tree(&binary, item);
    if tree.depth <= MAX_DEPTH {
        return tree;
    }
    // Nodes of two boxes are the worst that can happen: 28 levels.
    wide::tree(&cluster::tree(order.len(), |i| binary.bounds[i], 0), item)
}

impl Quality {
    /// Returns how far away, along the curve, a partner may be.
    fn radius(self) -> usize {
        match self {
            Self::Fast => 4,
            Self::Balanced | Self::Best => 10,
        }
    }

    /// Returns how many subtrees may look for a better place in each round.
    fn candidates(self, count: usize) -> Vec<usize> {
        match self {
            Self::Fast => Vec::new(),
            Self::Balanced => {
                // Three searches a shape while there are few, three for ten shapes at last;
                // most of them near the root, where most is gained.
                let first = count / 10 + count.min(20_000);
                (1..=8).map(|round| first / round).collect()
            }
            // On from where the others stop, so that more work is never worse.
            Self::Best => [Self::Balanced.candidates(count), vec![2 * count; 16]].concat(),
        }
    }
}

#[cfg(test)]
mod tests;
