//! Techniques one by one.

/// Any set of techniques (s, t) with s, t < 8: what is outside takes no part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TechniqueSet(u64);

impl TechniqueSet {
    /// Takes those of `pairs` (s, t) that fit.
    pub fn of(pairs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let bits = pairs.into_iter().filter_map(|(s, t)| bit(s, t));
        Self(bits.fold(0, |set, bit| set | bit))
    }

    /// Tells whether (s, t) is one of them.
    pub fn contains(self, s: usize, t: usize) -> bool {
        bit(s, t).is_some_and(|bit| self.0 & bit != 0)
    }
}

fn bit(s: usize, t: usize) -> Option<u64> {
    (s < 8 && t < 8).then(|| 1 << (8 * s + t))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_holds_what_was_put_in() {
        let set = TechniqueSet::of([(0, 2), (7, 7), (8, 1)]);
        for (s, t) in [(0, 2), (7, 7)] {
            assert!(set.contains(s, t));
        }
        for (s, t) in [(2, 0), (8, 1), (0, 9), (1, 2)] {
            assert!(!set.contains(s, t), "({s}, {t})");
        }
    }
}
