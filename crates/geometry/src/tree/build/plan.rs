//! The choice of the clusters that are merged in a round.

use super::bounds::Bounds;
use super::choice;
use crate::tree::parallel;

/// Clusters a task.
pub(super) const CHUNK: usize = 2048;

/// In a round at least this part of the clusters must find a partner.
const FEWEST: usize = 16;

pub(super) struct Plan<'a> {
    /// The choice of each cluster; itself where there is none.
    choices: &'a [u32],
    /// One a chunk.
    pub(super) counts: Vec<ChunkCounts>,
}

/// For a chunk of clusters, how many are left afterwards, and how many of these are
/// pairs.
#[derive(Clone, Copy, Default)]
pub(super) struct ChunkCounts {
    pub(super) left: usize,
    pub(super) pairs: usize,
}

/// The fate of a cluster in a round.
pub(super) enum Fate {
    Stays,
    MergesWith(usize),
    Goes,
}

impl<'a> Plan<'a> {
    /// Plans as many clusters as there is room for choices; `bounds` knows their boxes.
    pub(super) fn new(
        choices: &'a mut [u32],
        radius: usize,
        bounds: impl Fn(usize) -> Bounds + Sync,
    ) -> Self {
        if radius > 0 {
            choice::nearest(choices, radius, bounds);
            let plan = Plan::of(choices);
            // Of boxes that lie in each other like the coats of an onion, hardly any
            // two choose each other.
            if plan.pairs() * FEWEST >= plan.count() {
                let counts = plan.counts;
                return Self { choices, counts };
            }
        }
        choice::next(choices);
        Self::of(choices)
    }

    fn of(choices: &'a [u32]) -> Self {
        let mut plan = Self { choices, counts: Vec::new() };
        plan.counts = parallel::map(choices.len().div_ceil(CHUNK), 1, |i| plan.counts(i));
        plan
    }

    fn counts(&self, chunk: usize) -> ChunkCounts {
        let first = chunk * CHUNK;
        let mut counts = ChunkCounts::default();
        for i in first..self.count().min(first + CHUNK) {
            let fate = self.fate(i);
            counts.left += usize::from(!matches!(fate, Fate::Goes));
            counts.pairs += usize::from(matches!(fate, Fate::MergesWith(_)));
        }
        counts
    }

    #[inline]
    pub(super) fn fate(&self, i: usize) -> Fate {
        let j = self.choices[i] as usize;
        if i == j || self.choices[j] as usize != i {
            Fate::Stays
        } else if i < j {
            Fate::MergesWith(j)
        } else {
            Fate::Goes
        }
    }

    /// Returns the number of clusters.
    pub(super) fn count(&self) -> usize {
        self.choices.len()
    }

    pub(super) fn pairs(&self) -> usize {
        self.counts.iter().map(|counts| counts.pairs).sum()
    }
}
