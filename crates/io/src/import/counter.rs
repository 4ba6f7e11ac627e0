//! A counter of what was skipped or repaired in a file, each kind once with a count.

use crate::Warning;
use crate::warning_counts::WarningCounts;
use std::collections::HashMap;
use std::fmt::Display;

/// Kinds in the order in which they were met.
#[derive(Debug, Default)]
pub(super) struct Counter {
    kinds: Vec<(String, u32)>,
    places: HashMap<String, usize>,
}

impl Counter {
    /// More kinds than these are not told apart.
    const MOST: usize = 1000;

    pub(super) fn add(&mut self, what: impl Into<String>) {
        self.add_many(what, 1);
    }

    pub(super) fn add_many(&mut self, what: impl Into<String>, times: u32) {
        if times == 0 {
            return;
        }
        let mut what = what.into();
        if self.kinds.len() >= Self::MOST && !self.places.contains_key(&what) {
            what = "…".to_string();
        }
        let next = self.kinds.len();
        let place = *self.places.entry(what.clone()).or_insert(next);
        if place == next {
            self.kinds.push((what, 0));
        }
        self.kinds[place].1 = self.kinds[place].1.saturating_add(times);
    }

    /// Adds all that a decoder has counted.
    pub(super) fn add_counts<K: Ord + Display>(&mut self, counts: &WarningCounts<K>) {
        for (what, times) in counts.iter() {
            self.add_many(what, times);
        }
    }

    /// Makes them warnings about a file.
    pub(super) fn into_warnings(self, file: &str) -> impl Iterator<Item = Warning> {
        let named = move |(what, count)| Warning { file: file.to_string(), what, count };
        self.kinds.into_iter().map(named)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_keep_their_order_and_are_counted() {
        let mut counter = Counter::default();
        counter.add("b");
        counter.add("a");
        counter.add_many("b", 2);
        counter.add_many("c", 0);
        let shown: Vec<String> = counter.into_warnings("x").map(|w| w.to_string()).collect();
        assert_eq!(shown, ["x: b (3 times)", "x: a"]);
    }

    #[test]
    fn very_many_kinds_become_one() {
        let mut counter = Counter::default();
        (0..3000).for_each(|i| counter.add(i.to_string()));
        let warnings: Vec<Warning> = counter.into_warnings("x").collect();
        assert_eq!((warnings.len(), warnings[1000].count), (1001, 2000));
    }
}
