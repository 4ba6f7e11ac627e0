//! Which neighbour would make the smallest box?

use super::bounds::Bounds;
use super::cluster::CHUNK;
use crate::tree::parallel;

/// For each of two boxes or more the one at most `radius` places away that gives
/// the union of least area.
///
/// Of equal areas that with the least exclusive or of the two places counts, so
/// that equal boxes pair up: 0 with 1, 2 with 3.
pub(super) fn nearest(bounds: &[Bounds], radius: usize) -> Vec<u32> {
    let mut choices = vec![0; bounds.len()];
    let tasks = choices.chunks_mut(CHUNK).enumerate().collect();
    parallel::run(tasks, |(chunk, out)| fill(bounds, chunk * CHUNK, out, radius));
    choices
}

/// The choices of `first` and those that follow.
fn fill(bounds: &[Bounds], first: usize, choices: &mut [u32], radius: usize) {
    let start = first.saturating_sub(radius);
    let end = first + choices.len();
    // Every pair is looked at once, and counts for both.
    let mut best = vec![u64::MAX; end - start + radius];
    for i in start..end {
        let last = bounds.len().min(i + radius + 1);
        let (mine, theirs) = best[i - start..].split_at_mut(1);
        for ((j, &other), theirs) in (i + 1..).zip(&bounds[i + 1..last]).zip(theirs) {
            let key = key(bounds[i].union(other), i ^ j);
            mine[0] = mine[0].min(key);
            *theirs = key.min(*theirs);
        }
    }
    for ((i, choice), key) in (first..).zip(choices).zip(&best[first - start..]) {
        *choice = i as u32 ^ *key as u32;
    }
}

/// Ordered as the areas are, which are not negative, then as the differences.
#[inline]
fn key(union: Bounds, difference: usize) -> u64 {
    u64::from(union.area().to_bits()) << 32 | difference as u64
}
