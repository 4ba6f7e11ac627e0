//! The search for the place in a binary tree where a subtree costs least.

use super::binary::{Binary, NONE};
use super::bounds::Bounds;
use std::cmp::Reverse;

/// The most nodes looked at: where many boxes overlap, all might be worth a look.
const VISITS: usize = 512;

/// A subtree and its better place. Ordered by what is gained, most first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Move {
    /// Areas gained, as bits.
    gain: Reverse<u32>,
    pub(super) node: u32,
    /// The node beside which it goes.
    pub(super) to: u32,
}

/// Looks for places in a tree that stands still.
pub(super) struct Search<'a> {
    tree: &'a Binary,
    parents: &'a [u32],
    /// Nodes to look at, and what is gained above them.
    open: Vec<(f32, u32)>,
}

/// The best place so far.
struct Best {
    gain: f32,
    to: u32,
    visits: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(tree: &'a Binary, parents: &'a [u32]) -> Self {
        Self { tree, parents, open: Vec::new() }
    }

    /// The place where the subtree makes the sum of all areas least, if it gets
    /// less than it is.
    ///
    /// Taken out, a subtree spares its parent and lets all boxes above shrink;
    /// put in, it lets boxes there grow and makes a new parent. From its own place
    /// the search goes up and, from each node on the way, down on the other side.
    pub(super) fn best(&mut self, node: u32) -> Option<Move> {
        let bounds = self.tree.bounds[node as usize];
        let parent = self.parents[node as usize];
        let mut best = Best { gain: 0.0, to: NONE, visits: 0 };
        let mut spared = self.tree.area(parent);
        let mut side = self.sibling(parent, node);
        let mut rest = self.tree.bounds[side as usize];
        let mut above = parent;
        loop {
            self.descend(bounds, (spared, side), &mut best);
            let next = self.parents[above as usize];
            if next == NONE || best.visits > VISITS {
                break;
            }
            side = self.sibling(next, above);
            if above != parent {
                spared += self.tree.area(above) - rest.area();
            }
            rest = rest.union(self.tree.bounds[side as usize]);
            above = next;
        }
        let gain = Reverse(best.gain.to_bits());
        (best.to != NONE).then_some(Move { gain, node, to: best.to })
    }

    /// Looks at a node and what is below.
    fn descend(&mut self, bounds: Bounds, start: (f32, u32), best: &mut Best) {
        let area = bounds.area();
        self.open.push(start);
        while let Some((spared, at)) = self.open.pop() {
            // Nowhere is the new parent smaller than the subtree.
            if spared - area <= best.gain {
                continue;
            }
            best.visits += 1;
            let here = self.tree.bounds[at as usize];
            let gain = spared - here.union(bounds).area();
            if gain > best.gain {
                (best.gain, best.to) = (gain, at);
            }
            let below = gain + here.area();
            if let Some(children) = self.tree.children(at)
                && below - area > best.gain
            {
                self.open.extend(children.map(|child| (below, child)));
            }
        }
    }

    fn sibling(&self, parent: u32, node: u32) -> u32 {
        let children = self.tree.children(parent).unwrap_or([NONE; 2]);
        if children[0] == node { children[1] } else { children[0] }
    }
}
