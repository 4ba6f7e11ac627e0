//! The few ways in which work on a tree is spread over threads.
//!
//! Without the feature `rayon`, or with one thread, all runs in turn. Results never
//! depend on the number of threads: everything comes back in the order of its
//! numbers.

use super::pages::room;
#[cfg(feature = "rayon")]
use rayon::prelude::*;
use std::ops::Range;

/// Returns what `f` makes of 0, 1, …, `count` − 1. A thread takes at least `grain` at once.
pub(crate) fn map<T: Send>(
    count: usize,
    grain: usize,
    f: impl Fn(usize) -> T + Send + Sync,
) -> Vec<T> {
    let mut list = room(count);
    #[cfg(feature = "rayon")]
    if count > grain && rayon::current_num_threads() > 1 {
        (0..count).into_par_iter().with_min_len(grain).map(f).collect_into_vec(&mut list);
        return list;
    }
    let _ = grain;
    list.extend((0..count).map(f));
    list
}

/// Returns what `f` makes of each chunk of so many numbers of 0, 1, …, `count` − 1.
pub(crate) fn chunks<T: Send>(
    count: usize,
    size: usize,
    f: impl Fn(Range<usize>) -> T + Send + Sync,
) -> Vec<T> {
    map(count.div_ceil(size), 1, |i| f(i * size..count.min((i + 1) * size)))
}

/// The numbers below `count` that `keep` holds for, in chunks of so many looked at.
pub(crate) fn filter(
    count: usize,
    size: usize,
    keep: impl Fn(usize) -> bool + Send + Sync,
) -> Vec<u32> {
    let counts = chunks(count, size, |range| range.filter(|&i| keep(i)).count());
    let mut found = vec![0; counts.iter().sum()];
    let mut rest = &mut found[..];
    let tasks = counts.iter().enumerate().map(|(i, &counts)| (i * size, cut(&mut rest, counts)));
    run(tasks.collect(), |(first, out)| {
        let kept = (first..count.min(first + size)).filter(|&i| keep(i));
        out.iter_mut().zip(kept).for_each(|(slot, i)| *slot = i as u32);
    });
    found
}

/// Calls `f` for each task.
pub(crate) fn run<T: Send>(tasks: Vec<T>, f: impl Fn(T) + Send + Sync) {
    #[cfg(feature = "rayon")]
    if tasks.len() > 1 && rayon::current_num_threads() > 1 {
        return tasks.into_par_iter().for_each(f);
    }
    tasks.into_iter().for_each(f);
}

/// Both results; `wide` tells whether a second thread would be worth it.
pub(crate) fn join<A: Send, B: Send>(
    wide: bool,
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "rayon")]
    if wide && rayon::current_num_threads() > 1 {
        return rayon::join(a, b);
    }
    let _ = wide;
    (a(), b())
}

/// Sorts keys of which no two are equal.
pub(crate) fn sort<T: Ord + Send>(keys: &mut [T]) {
    #[cfg(feature = "rayon")]
    if keys.len() > 1 << 13 && rayon::current_num_threads() > 1 {
        return keys.par_sort_unstable();
    }
    keys.sort_unstable();
}

/// Cuts the first `count` elements off.
#[expect(clippy::mut_mut, reason = "the rest is left in the place of the whole")]
pub(crate) fn cut<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (front, rest) = std::mem::take(slice).split_at_mut(count);
    *slice = rest;
    front
}
