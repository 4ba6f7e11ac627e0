//! Binary trees in depth-first order, and what it costs to make them wide.
//!
//! Ylitie, Karras, Laine: Efficient Incoherent Ray Traversal on GPUs Through
//! Compressed Wide BVHs, 2017, section 3.1. For each node and each number of
//! places among its parent's children: how cheap is what lies below if it gets at
//! most so many places?

use super::GRAIN;
use super::binary::Binary;
use super::cost::{Costs, Kind, Summary};
use crate::tree::parallel::{self, cut};

/// Subtrees of at most this height are not worth a thread.
const SERIAL_HEIGHT: u32 = 11;

/// A node with two children. Those of its first child follow, then those of its
/// second.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlatNode {
    /// In the binary tree.
    pub(super) node: u32,
    /// Items below the first child.
    pub(super) split: u32,
    pub(super) costs: Costs,
    /// True if, where there is one place, a leaf is cheaper than a node.
    pub(super) is_leaf: bool,
}

/// A binary tree in depth-first order.
#[derive(Debug)]
pub(super) struct FlatTree {
    pub(super) nodes: Vec<FlatNode>,
    /// Nodes of the binary tree that are items.
    pub(super) items: Vec<u32>,
}

impl FlatTree {
    pub(super) fn new(tree: &Binary, kind: impl Fn(u32) -> Kind + Sync) -> Self {
        let none = FlatNode { node: 0, split: 0, costs: [0.0; 7], is_leaf: false };
        // Every thread gets its share of fresh memory.
        let mut nodes = parallel::map(tree.count() - 1, GRAIN, |_| none);
        let mut items = vec![0; tree.count()];
        let counts = ItemCounts::of(tree, tree.root);
        let out = Out { nodes: &mut nodes, items: &mut items };
        Flattener { tree, kind }.tall(tree.root, &counts, out);
        Self { nodes, items }
    }
}

/// The number of items below a node, and of each child if the node is tall.
struct ItemCounts {
    count: usize,
    children: Option<Box<[ItemCounts; 2]>>,
}

impl ItemCounts {
    fn of(tree: &Binary, node: u32) -> Self {
        match tree.inner(node) {
            Some(inner) if inner.height > SERIAL_HEIGHT => {
                let [a, b] = inner.children;
                let (a, b) = parallel::join(true, || Self::of(tree, a), || Self::of(tree, b));
                Self { count: a.count + b.count, children: Some(Box::new([a, b])) }
            }
            _ => Self { count: count(tree, node), children: None },
        }
    }
}

fn count(tree: &Binary, node: u32) -> usize {
    tree.children(node).map_or(1, |[a, b]| count(tree, a) + count(tree, b))
}

/// The place that a subtree is written to.
struct Out<'a> {
    nodes: &'a mut [FlatNode],
    items: &'a mut [u32],
}

struct Flattener<'a, K> {
    tree: &'a Binary,
    kind: K,
}

impl<K: Fn(u32) -> Kind + Sync> Flattener<'_, K> {
    fn tall(&self, node: u32, counts: &ItemCounts, mut out: Out) -> Summary {
        let (Some([a, b]), Some(counts)) = (self.tree.children(node), &counts.children) else {
            return self.short(node, &mut out);
        };
        let slot = &mut cut(&mut out.nodes, 1)[0];
        let first = Out {
            nodes: cut(&mut out.nodes, counts[0].count - 1),
            items: cut(&mut out.items, counts[0].count),
        };
        let (a, b) = parallel::join(
            true,
            || self.tall(a, &counts[0], first),
            || self.tall(b, &counts[1], out),
        );
        self.unite(node, &a, &b, slot)
    }

    fn short(&self, node: u32, out: &mut Out) -> Summary {
        let Some([a, b]) = self.tree.children(node) else {
            cut(&mut out.items, 1)[0] = node;
            return Summary::of_item(self.tree.area(node), (self.kind)(node));
        };
        let slot = &mut cut(&mut out.nodes, 1)[0];
        let a = self.short(a, out);
        let b = self.short(b, out);
        self.unite(node, &a, &b, slot)
    }

    fn unite(&self, node: u32, a: &Summary, b: &Summary, slot: &mut FlatNode) -> Summary {
        let (summary, is_leaf) = Summary::of_node(self.tree.area(node), a, b);
        *slot = FlatNode { node, split: a.count, costs: summary.costs, is_leaf };
        summary
    }
}
