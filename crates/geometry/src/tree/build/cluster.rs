//! Binary trees from the leaves up.
//!
//! Meister, Bittner: Parallel Locally-Ordered Clustering for Bounding Volume
//! Hierarchy Construction, 2018. Items lie along a curve. In every round each
//! cluster looks for the neighbour within a radius with which it would make the
//! smallest box; two that choose each other become one.

use super::GRAIN;
use super::binary::{Binary, Inner};
use super::bounds::Bounds;
use super::plan::{CHUNK, Fate, Plan};
use crate::tree::parallel::{self, cut};

/// After so many rounds neighbours are paired as they come, which keeps the
/// height below this plus the 28 bits of the largest count. A round leaves about
/// two thirds, so that 2²⁸ items take 48.
const ROUNDS: usize = 64;

/// A tree over one item or more with these bounds, in this order. With radius 0 neighbours are
/// paired as they come, and the tree is as flat as can be.
pub(super) fn tree(
    count: usize,
    bounds: impl Fn(usize) -> Bounds + Send + Sync,
    radius: usize,
) -> Binary {
    let mut tree = Binary::leaves(count, bounds);
    // The nodes that are left to merge.
    let mut clusters = parallel::map(count, GRAIN, |i| i as u32);
    // Used again in every round: fresh memory takes longer than what is done there.
    let (mut choices, mut next) = (vec![0; count], vec![0; count]);
    let mut made = 0;
    for round in 0.. {
        if clusters.len() == 1 {
            break;
        }
        choices.truncate(clusters.len());
        let radius = if round < ROUNDS { radius } else { 0 };
        let plan = Plan::new(&mut choices, radius, |i| tree.bounds[clusters[i] as usize]);
        next.truncate(clusters.len() - plan.pairs());
        merge(&clusters, &plan, &mut tree, made, &mut next);
        made += plan.pairs();
        std::mem::swap(&mut clusters, &mut next);
    }
    tree
}

/// Writes what is left after a round, which goes on after `made` nodes.
fn merge(clusters: &[u32], plan: &Plan, tree: &mut Binary, made: usize, mut left: &mut [u32]) {
    let count = tree.count();
    let (known, mut bounds) = tree.bounds.split_at_mut(count + made);
    let (done, mut inner) = tree.inner.split_at_mut(made);
    let mut number = count + made;
    let mut tasks = Vec::with_capacity(plan.counts.len());
    for (chunk, counts) in plan.counts.iter().enumerate() {
        tasks.push(Task {
            first: chunk * CHUNK,
            number: number as u32,
            bounds: cut(&mut bounds, counts.pairs),
            inner: cut(&mut inner, counts.pairs),
            left: cut(&mut left, counts.left),
        });
        number += counts.pairs;
    }
    let height = |node: u32| (node as usize).checked_sub(count).map_or(0, |i| done[i].height);
    let unite = |children: [u32; 2]| {
        let [a, b] = children.map(|child| known[child as usize]);
        let height = 1 + height(children[0]).max(height(children[1]));
        (a.union(b), Inner { children, height })
    };
    parallel::run(tasks, |task| task.run(clusters, plan, unite));
}

/// A chunk of clusters, the nodes made of them and the clusters left.
struct Task<'a> {
    /// The first cluster.
    first: usize,
    /// The number of the first node.
    number: u32,
    bounds: &'a mut [Bounds],
    inner: &'a mut [Inner],
    left: &'a mut [u32],
}

impl Task<'_> {
    fn run(self, clusters: &[u32], plan: &Plan, unite: impl Fn([u32; 2]) -> (Bounds, Inner)) {
        let mut made = 0;
        let mut left = self.left.iter_mut();
        for i in self.first..plan.count().min(self.first + CHUNK) {
            let node = match plan.fate(i) {
                Fate::Goes => continue,
                Fate::Stays => clusters[i],
                Fate::MergesWith(j) => {
                    (self.bounds[made], self.inner[made]) = unite([clusters[i], clusters[j]]);
                    made += 1;
                    self.number + made as u32 - 1
                }
            };
            if let Some(left) = left.next() {
                *left = node;
            }
        }
    }
}
