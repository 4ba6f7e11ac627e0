//! Better binary trees by taking subtrees out and putting them elsewhere.
//!
//! Meister, Bittner: Parallel Reinsertion for Bounding Volume Hierarchy
//! Optimization, 2018. Places are looked for while the tree stands still, and
//! taken in the order of what they gain, so threads do not change the result.

use super::binary::{Binary, Inner, NONE};
use super::search::{Move, Search};
use crate::tree::parallel;

/// No binary tree gets higher, so that recursion is safe whatever the items.
const MAX_HEIGHT: u32 = 128;

/// Searches a task.
const CHUNK: usize = 64;

/// Areas on the way up a tree are summed; the greatest may be this part of what
/// can be written down.
const ROOM: f32 = 1024.0;

/// Tries to move the `candidates` largest subtrees, and again for each number.
pub(super) fn improve(tree: &mut Binary, candidates: impl IntoIterator<Item = usize>) {
    if tree.count() < 3 || tree.area(tree.root) > f32::MAX / ROOM {
        return;
    }
    let parents = tree.parents();
    let mut optimiser = Optimiser { tree, parents };
    for candidates in candidates {
        if optimiser.round(candidates) == 0 {
            break;
        }
    }
}

struct Optimiser<'a> {
    tree: &'a mut Binary,
    parents: Vec<u32>,
}

impl Optimiser<'_> {
    /// Returns how many subtrees have been moved.
    fn round(&mut self, candidates: usize) -> usize {
        let candidates = largest(self.tree, candidates);
        let mut moves = self.moves(&candidates);
        parallel::sort(&mut moves);
        let mut touched = vec![false; self.parents.len()];
        moves.iter().filter(|m| self.apply(m, &mut touched)).count()
    }

    /// What each subtree gains where it would gain most.
    fn moves(&self, candidates: &[u32]) -> Vec<Move> {
        let chunks = candidates.chunks(CHUNK).collect::<Vec<_>>();
        let found = parallel::map(chunks.len(), 1, |i| {
            let mut search = Search::new(self.tree, &self.parents);
            chunks[i].iter().filter_map(|&node| search.best(node)).collect::<Vec<_>>()
        });
        found.concat()
    }

    /// Moves a subtree, unless something there has changed in this round.
    fn apply(&mut self, m: &Move, touched: &mut [bool]) -> bool {
        let (node, to) = (m.node, m.to);
        let parent = self.parents[node as usize];
        if parent == NONE || self.parents[to as usize] == NONE {
            return false;
        }
        let sibling = self.sibling(parent, node);
        let affected = [node, to, sibling, parent, self.parents[to as usize]];
        if affected.iter().any(|&i| touched[i as usize]) || !self.fits(node, to) {
            return false;
        }
        affected.iter().for_each(|&i| touched[i as usize] = true);
        self.take_out(parent, sibling);
        self.put_in(parent, node, to);
        true
    }

    /// Whether `to` is not below `node`, and `node` beside it not too deep.
    fn fits(&self, node: u32, to: u32) -> bool {
        let height = self.tree.height(node).max(self.tree.height(to));
        let mut levels = 0;
        let mut above = to;
        while above != NONE && above != node {
            levels += 1;
            above = self.parents[above as usize];
        }
        above == NONE && levels + height <= MAX_HEIGHT
    }

    fn sibling(&self, parent: u32, node: u32) -> u32 {
        let [a, b] = self.inner(parent).children;
        if a == node { b } else { a }
    }

    fn inner(&self, node: u32) -> Inner {
        self.tree.inner[node as usize - self.tree.count()]
    }

    /// Puts `sibling` in the place of its parent.
    fn take_out(&mut self, parent: u32, sibling: u32) {
        let above = self.parents[parent as usize];
        self.replace(above, parent, sibling);
        self.refit(above);
    }

    /// Makes `parent` that of `node` and `to`, in the place of `to`.
    fn put_in(&mut self, parent: u32, node: u32, to: u32) {
        let above = self.parents[to as usize];
        self.replace(above, to, parent);
        let count = self.tree.count();
        self.tree.inner[parent as usize - count].children = [node, to];
        self.parents[to as usize] = parent;
        // Whatever it was before, it counts as changed.
        self.tree.inner[parent as usize - count].height = 0;
        self.refit(parent);
    }

    /// Lets `new` be where `old` was below `above`, or the root.
    fn replace(&mut self, above: u32, old: u32, new: u32) {
        self.parents[new as usize] = above;
        if above == NONE {
            self.tree.root = new;
            return;
        }
        let count = self.tree.count();
        for child in &mut self.tree.inner[above as usize - count].children {
            if *child == old {
                *child = new;
            }
        }
    }

    /// Corrects boxes and heights from a node up, as far as they change.
    fn refit(&mut self, mut node: u32) {
        let tree = &mut *self.tree;
        while node != NONE {
            let [a, b] = tree.inner[node as usize - tree.count()].children;
            let bounds = tree.bounds[a as usize].union(tree.bounds[b as usize]);
            let height = 1 + tree.height(a).max(tree.height(b));
            let index = node as usize - tree.count();
            if tree.bounds[node as usize] == bounds && tree.inner[index].height == height {
                break;
            }
            tree.bounds[node as usize] = bounds;
            tree.inner[index].height = height;
            node = self.parents[node as usize];
        }
    }
}

/// Areas looked at to find out which are large.
const SAMPLES: usize = 4096;

/// About `wanted` nodes of large area, without the root.
fn largest(tree: &Binary, wanted: usize) -> Vec<u32> {
    let least = threshold(tree, wanted);
    let mut found = Vec::with_capacity(wanted);
    let mut open: Vec<u32> = Vec::new();
    let mut next = Some(tree.root);
    while let Some(node) = next {
        open.extend(tree.children(node).into_iter().flatten());
        next = open.pop();
        while let Some(node) = next
            && tree.area(node) < least
        {
            next = open.pop();
        }
        found.extend(next);
    }
    found
}

/// The area that about `wanted` nodes have.
fn threshold(tree: &Binary, wanted: usize) -> f32 {
    let nodes = tree.bounds.len();
    if wanted >= nodes {
        return 0.0;
    }
    let stride = nodes.div_ceil(SAMPLES);
    let mut areas: Vec<f32> = tree.bounds.iter().step_by(stride).map(|b| b.area()).collect();
    let index = (wanted / stride).min(areas.len() - 1);
    *areas.select_nth_unstable_by(index, |a, b| b.total_cmp(a)).1
}
