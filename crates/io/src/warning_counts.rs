//! Counts of the warnings about a file, by kind.

use std::collections::BTreeMap;
use std::fmt::Display;

/// Kinds with counts, in a fixed order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WarningCounts<K> {
    kinds: BTreeMap<K, u32>,
    others: u32,
}

/// More kinds than these are not told apart.
const MOST: usize = 1000;

impl<K> Default for WarningCounts<K> {
    fn default() -> Self {
        Self { kinds: BTreeMap::new(), others: 0 }
    }
}

impl<K: Ord> WarningCounts<K> {
    pub(crate) fn add(&mut self, kind: K) {
        self.add_many(kind, 1);
    }

    pub(crate) fn add_many(&mut self, kind: K, times: usize) {
        if times == 0 {
            return;
        }
        let times = u32::try_from(times).unwrap_or(u32::MAX);
        let is_new = self.kinds.len() >= MOST && !self.kinds.contains_key(&kind);
        let count = if is_new { &mut self.others } else { self.kinds.entry(kind).or_insert(0) };
        *count = count.saturating_add(times);
    }

    /// Returns how often a kind was met.
    pub fn count(&self, kind: &K) -> u32 {
        self.kinds.get(kind).copied().unwrap_or(0)
    }
}

impl<K: Display> WarningCounts<K> {
    /// Every kind that was met, in words, with its count.
    pub fn iter(&self) -> impl Iterator<Item = (String, u32)> {
        let known = self.kinds.iter().map(|(kind, &count)| (kind.to_string(), count));
        known.chain((self.others > 0).then(|| ("…".to_string(), self.others)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_counted_and_too_many_become_one() {
        let mut counts = WarningCounts::default();
        (0..1100).for_each(|kind| counts.add(kind % 1050));
        counts.add_many(3, 0);
        assert_eq!((counts.count(&3), counts.count(&999), counts.count(&1049)), (2, 1, 0));
        assert_eq!(counts.iter().last(), Some(("…".to_string(), 50)));
    }
}
