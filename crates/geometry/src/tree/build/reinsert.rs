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

/// Large nodes are looked for in so many subtrees at once.
const SUBTREES: usize = 64;

/// Areas on the way up a tree are summed; the greatest may be this part of what
/// can be written down.
const ROOM: f32 = 1024.0;

/// Tries to move the `candidates` largest subtrees, and again for each number.
pub(super) fn improve(tree: &mut Binary, candidates: impl IntoIterator<Item = usize>) {
    if tree.count() < 3 || tree.area(tree.root) > f32::MAX / ROOM {
        return;
    }
    let parents = tree.parents();
    let touched = vec![false; parents.len()];
    let mut optimiser = Optimiser { tree, parents, touched };
    for candidates in candidates {
        let all = candidates >= optimiser.parents.len();
        if optimiser.round(candidates) == 0 && all {
            break;
        }
    }
}

struct Optimiser<'a> {
    tree: &'a mut Binary,
    parents: Vec<u32>,
    /// The nodes that have changed in this round.
    touched: Vec<bool>,
}

impl Optimiser<'_> {
    /// Returns how many subtrees have been moved.
    fn round(&mut self, candidates: usize) -> usize {
        let candidates = largest(self.tree, candidates);
        let mut moves = self.moves(&candidates);
        parallel::sort(&mut moves);
        self.touched.fill(false);
        moves.iter().filter(|m| self.apply(m)).count()
    }

    /// Finds for each subtree the move by which most is gained.
    fn moves(&self, candidates: &[u32]) -> Vec<Move> {
        let chunks = candidates.chunks(CHUNK).collect::<Vec<_>>();
        let found = parallel::map(chunks.len(), 1, |i| {
            let mut search = Search::new(self.tree, &self.parents);
            chunks[i].iter().filter_map(|&node| search.best(node)).collect::<Vec<_>>()
        });
        found.concat()
    }

    /// Moves a subtree, unless something there has changed in this round.
    fn apply(&mut self, m: &Move) -> bool {
        let (node, to) = (m.node, m.to);
        let parent = self.parents[node as usize];
        if parent == NONE || self.parents[to as usize] == NONE {
            return false;
        }
        let sibling = self.sibling(parent, node);
        let affected = [node, to, sibling, parent, self.parents[to as usize]];
        if affected.iter().any(|&i| self.touched[i as usize]) || !self.fits(node, to) {
            return false;
        }
        for i in affected {
            self.touched[i as usize] = true;
        }
        self.take_out(parent, sibling);
        self.put_in(parent, node, to);
        true
    }

    /// Tells whether `to` is not below `node`, and `node` beside it not too deep.
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

/// About `wanted` nodes of large area, without the root. What is below a small one
/// is small.
fn largest(tree: &Binary, wanted: usize) -> Vec<u32> {
    let least = threshold(tree, wanted);
    let mut found = Vec::with_capacity(wanted);
    let mut level = vec![tree.root];
    while (1..SUBTREES).contains(&level.len()) {
        level = level.iter().flat_map(|&node| large(tree, node, least)).collect();
        found.extend_from_slice(&level);
    }
    let below = |i: usize| all_large(tree, level[i], least);
    found.extend(parallel::map(level.len(), 1, below).into_iter().flatten());
    found
}

/// The large nodes below one, depth first, so that neighbours in the list mostly are
/// neighbours in space.
fn all_large(tree: &Binary, node: u32, least: f32) -> Vec<u32> {
    let mut found = Vec::new();
    let mut open: Vec<u32> = large(tree, node, least).collect();
    while let Some(node) = open.pop() {
        found.push(node);
        open.extend(large(tree, node, least));
    }
    found
}

/// The large children of a node.
fn large(tree: &Binary, node: u32, least: f32) -> impl Iterator<Item = u32> {
    let children = tree.children(node).into_iter().flatten();
    children.filter(move |&child| tree.area(child) >= least)
}

/// The area that about `wanted` nodes have.
fn threshold(tree: &Binary, wanted: usize) -> f32 {
    let nodes = tree.bounds.len();
    if wanted >= nodes {
        return 0.0;
    }
    let stride = nodes.div_ceil(SAMPLES);
    let area = |i: usize| tree.bounds[i * stride].area();
    let mut areas = parallel::map(nodes.div_ceil(stride), SAMPLES / 8, area);
    let index = (wanted / stride).min(areas.len() - 1);
    *areas.select_nth_unstable_by(index, |a, b| b.total_cmp(a)).1
}
