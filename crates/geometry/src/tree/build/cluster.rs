//! Binary trees from the leaves up.
//!
//! Meister, Bittner: Parallel Locally-Ordered Clustering for Bounding Volume
//! Hierarchy Construction, 2018. Items lie along a curve. In every round each
//! cluster looks for the neighbour within a radius with which it would make the
//! smallest box; two that choose each other become one.

use super::binary::{Binary, Inner};
use super::bounds::Bounds;
use super::choice;
use crate::Aabb;
use crate::tree::parallel::{self, cut};

/// Clusters a task.
pub(super) const CHUNK: usize = 2048;

/// After so many rounds neighbours are paired as they come, which keeps the
/// height below this plus the 28 bits of the largest count. A round leaves about
/// two thirds, so that 2²⁸ items take 48.
const ROUNDS: usize = 64;

/// In a round at least this part of the clusters must find a partner.
const FEWEST: usize = 16;

/// A tree over one item or more in this order. With radius 0 neighbours are paired
/// as they come, and the tree is as flat as can be.
pub(super) fn tree(boxes: &[Aabb], order: &[u32], radius: usize) -> Binary {
    let mut tree = Binary::leaves(order.len(), |i| boxes[order[i] as usize].into());
    let mut clusters = Clusters {
        bounds: tree.bounds[..order.len()].to_vec(),
        nodes: (0..order.len() as u32).collect(),
    };
    let mut made = 0;
    for round in 0.. {
        if clusters.nodes.len() == 1 {
            break;
        }
        let plan = Plan::new(&clusters.bounds, if round < ROUNDS { radius } else { 0 });
        clusters = merged(&clusters, &plan, &mut tree, made);
        made += plan.pairs();
    }
    tree
}

/// What is left to merge: boxes, and the nodes that have them.
struct Clusters {
    bounds: Vec<Bounds>,
    nodes: Vec<u32>,
}

/// Who is merged with whom in a round.
struct Plan {
    /// The choice of each cluster; itself where there is none.
    choices: Vec<u32>,
    tallies: Vec<Tally>,
}

/// Of a chunk of clusters: how many are left afterwards, and how many of these are
/// pairs.
#[derive(Clone, Copy, Default)]
struct Tally {
    left: usize,
    pairs: usize,
}

/// What becomes of a cluster.
enum Fate {
    Stays,
    MergesWith(usize),
    Goes,
}

impl Plan {
    fn new(bounds: &[Bounds], radius: usize) -> Self {
        if radius > 0 {
            let plan = Self::of(choice::nearest(bounds, radius));
            // Of boxes that lie in each other like the coats of an onion, hardly any
            // two choose each other.
            if plan.pairs() * FEWEST >= bounds.len() {
                return plan;
            }
        }
        let next = |i: usize| if i ^ 1 < bounds.len() { i ^ 1 } else { i };
        Self::of(parallel::map(bounds.len(), CHUNK, |i| next(i) as u32))
    }

    fn of(choices: Vec<u32>) -> Self {
        let mut plan = Self { choices, tallies: Vec::new() };
        plan.tallies = parallel::map(plan.choices.len().div_ceil(CHUNK), 1, |i| plan.tally(i));
        plan
    }

    fn tally(&self, chunk: usize) -> Tally {
        let first = chunk * CHUNK;
        let mut tally = Tally::default();
        for i in first..self.choices.len().min(first + CHUNK) {
            let fate = self.fate(i);
            tally.left += usize::from(!matches!(fate, Fate::Goes));
            tally.pairs += usize::from(matches!(fate, Fate::MergesWith(_)));
        }
        tally
    }

    #[inline]
    fn fate(&self, i: usize) -> Fate {
        let j = self.choices[i] as usize;
        if i == j || self.choices[j] as usize != i {
            Fate::Stays
        } else if i < j {
            Fate::MergesWith(j)
        } else {
            Fate::Goes
        }
    }

    fn pairs(&self) -> usize {
        self.tallies.iter().map(|tally| tally.pairs).sum()
    }
}

/// What is left after a round, which goes on after `made` nodes.
fn merged(clusters: &Clusters, plan: &Plan, tree: &mut Binary, made: usize) -> Clusters {
    let count = tree.count();
    let left = clusters.nodes.len() - plan.pairs();
    let mut next = Clusters { bounds: vec![Bounds::EMPTY; left], nodes: vec![0; left] };
    let (done, mut inner) = tree.inner.split_at_mut(made);
    let mut bounds = &mut tree.bounds[count + made..];
    let (mut next_bounds, mut next_nodes) = (&mut next.bounds[..], &mut next.nodes[..]);
    let mut number = count + made;
    let mut tasks = Vec::with_capacity(plan.tallies.len());
    for (chunk, tally) in plan.tallies.iter().enumerate() {
        tasks.push(Task {
            first: chunk * CHUNK,
            number: number as u32,
            bounds: cut(&mut bounds, tally.pairs),
            inner: cut(&mut inner, tally.pairs),
            next_bounds: cut(&mut next_bounds, tally.left),
            next_nodes: cut(&mut next_nodes, tally.left),
        });
        number += tally.pairs;
    }
    let height = |node: u32| (node as usize).checked_sub(count).map_or(0, |i| done[i].height);
    parallel::run(tasks, |task| task.run(clusters, plan, height));
    next
}

/// A chunk of clusters, the nodes made of them and the clusters left.
struct Task<'a> {
    /// The first cluster.
    first: usize,
    /// Of the first node.
    number: u32,
    bounds: &'a mut [Bounds],
    inner: &'a mut [Inner],
    next_bounds: &'a mut [Bounds],
    next_nodes: &'a mut [u32],
}

impl Task<'_> {
    fn run(self, clusters: &Clusters, plan: &Plan, height: impl Fn(u32) -> u32) {
        let (mut made, mut left) = (0, 0);
        for i in self.first..plan.choices.len().min(self.first + CHUNK) {
            let (bounds, node) = match plan.fate(i) {
                Fate::Goes => continue,
                Fate::Stays => (clusters.bounds[i], clusters.nodes[i]),
                Fate::MergesWith(j) => {
                    let children = [clusters.nodes[i], clusters.nodes[j]];
                    let bounds = clusters.bounds[i].union(clusters.bounds[j]);
                    self.bounds[made] = bounds;
                    let height = 1 + height(children[0]).max(height(children[1]));
                    self.inner[made] = Inner { children, height };
                    made += 1;
                    (bounds, self.number + made as u32 - 1)
                }
            };
            (self.next_bounds[left], self.next_nodes[left]) = (bounds, node);
            left += 1;
        }
    }
}
