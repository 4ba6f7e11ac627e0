//! The few ways in which work on a tree is spread over threads.
//!
//! Without the feature `rayon`, or with one thread, all runs in turn. Results never
//! depend on the number of threads: everything comes back in the order of its
//! numbers.

#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// What `f` makes of 0, 1, …, `count` − 1. A thread takes at least `grain` at once.
pub(crate) fn map<T: Send>(
    count: usize,
    grain: usize,
    f: impl Fn(usize) -> T + Send + Sync,
) -> Vec<T> {
    #[cfg(feature = "rayon")]
    if count > grain && rayon::current_num_threads() > 1 {
        return (0..count).into_par_iter().with_min_len(grain).map(f).collect();
    }
    let _ = grain;
    (0..count).map(f).collect()
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
pub(crate) fn cut<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (front, rest) = std::mem::take(slice).split_at_mut(count);
    *slice = rest;
    front
}
