//! Trees with two children a node.

use super::GRAIN;
use super::bounds::Bounds;
use crate::tree::parallel;

/// No node.
pub(super) const NONE: u32 = u32::MAX;

/// Two children, and the levels of nodes from here down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Inner {
    pub(super) children: [u32; 2],
    pub(super) height: u32,
}

/// A binary tree over one item or more. Nodes below [`count`](Self::count) are
/// the items.
#[derive(Debug)]
pub(super) struct Binary {
    /// The bounds of all nodes.
    pub(super) bounds: Vec<Bounds>,
    /// The inner nodes, which are node `count` and those that follow.
    pub(super) inner: Vec<Inner>,
    pub(super) root: u32,
}

impl Binary {
    /// The items, with room for the nodes above them.
    pub(super) fn leaves(count: usize, bounds: impl Fn(usize) -> Bounds + Send + Sync) -> Self {
        let nodes = 2 * count - 1;
        let bounds = |i| if i < count { bounds(i) } else { Bounds::EMPTY };
        Self {
            bounds: parallel::map(nodes, GRAIN, bounds),
            inner: parallel::map(count - 1, GRAIN, |_| Inner { children: [NONE; 2], height: 0 }),
            root: nodes as u32 - 1,
        }
    }

    pub(super) fn count(&self) -> usize {
        self.inner.len() + 1
    }

    /// The children of a node; `None` of an item.
    #[inline]
    pub(super) fn children(&self, node: u32) -> Option<[u32; 2]> {
        Some(self.inner(node)?.children)
    }

    #[inline]
    pub(super) fn inner(&self, node: u32) -> Option<&Inner> {
        (node as usize).checked_sub(self.count()).map(|i| &self.inner[i])
    }

    /// Levels of nodes from here down, none for an item.
    #[inline]
    pub(super) fn height(&self, node: u32) -> u32 {
        self.inner(node).map_or(0, |inner| inner.height)
    }

    #[inline]
    pub(super) fn area(&self, node: u32) -> f32 {
        self.bounds[node as usize].area()
    }

    /// The parent of each node; [`NONE`] of the root.
    pub(super) fn parents(&self) -> Vec<u32> {
        let mut parents = parallel::map(self.bounds.len(), GRAIN, |_| NONE);
        for (parent, inner) in (self.count() as u32..).zip(&self.inner) {
            for child in inner.children {
                parents[child as usize] = parent;
            }
        }
        parents
    }
}
