//! Parts of a rendering, each for a process of its own.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// One of several parts of a rendering, which together have all of its passes once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// The number of the part, from 0.
    index: u32,
    /// The number of all parts.
    count: u32,
}

/// Blocks of passes in a shard, where there are so many passes: shards differ by one of
/// them, and the sums of a block are kept as one.
const BLOCKS: u32 = 8;

impl Shard {
    /// The only part.
    pub(crate) const WHOLE: Self = Self { index: 0, count: 1 };

    /// Tells whether both are parts of as many.
    pub(crate) fn is_beside(self, other: Self) -> bool {
        self.count == other.count
    }

    /// All parts of as many.
    pub(crate) fn all(self) -> impl Iterator<Item = Self> {
        (0..self.count).map(move |index| Self { index, ..self })
    }

    /// Its passes, of so many. Parts begin and end at multiples of a power of two, so that
    /// films of parts are small.
    pub fn passes(self, spp: u32) -> Range<u32> {
        let most = u64::from(spp) / (u64::from(BLOCKS) * u64::from(self.count));
        let block = most.checked_ilog2().map_or(1, |log| 1 << log);
        let blocks = u64::from(spp).div_ceil(block);
        let start = |index: u32| {
            let first = blocks * u64::from(index) / u64::from(self.count);
            (first * block).min(spp.into()) as u32
        };
        start(self.index)..start(self.index + 1)
    }
}

/// Writes it as on the command line.
impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        text.split_once('/')
            .and_then(|(index, count)| {
                Some(Self { index: index.parse().ok()?, count: count.parse().ok()? })
            })
            .filter(|shard| shard.index < shard.count)
            .ok_or("wanted as I/N, with I from 0 to N - 1")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_parts_have_each_pass_once() {
        for spp in [1, 2, 6, 7, 64, 100, 4096, 1_000_003] {
            for count in [1, 2, 3, 7, 100, 10_000] {
                let mut next = 0;
                let (mut least, mut most) = (spp, 0);
                for shard in (Shard { index: 0, count }).all() {
                    let passes = shard.passes(spp);
                    assert_eq!(passes.start, next, "{shard} {spp}");
                    next = passes.end;
                    least = least.min(passes.len() as u32);
                    most = most.max(passes.len() as u32);
                }
                assert_eq!(next, spp);
                // The last block may be cut off.
                assert!(most <= least + 1 + 2 * (spp / count / BLOCKS), "{spp} {count}");
            }
        }
        assert_eq!(Shard { index: 3, count: 7 }.passes(4096), 1728..2304);
        let last = Shard { index: u32::MAX - 1, count: u32::MAX };
        assert_eq!(last.passes(u32::MAX), u32::MAX - 1..u32::MAX);
    }

    #[test]
    fn parts_are_counted_from_zero() {
        let shard: Shard = "3/7".parse().unwrap();
        assert_eq!(shard.to_string(), "3/7");
        for bad in ["7/7", "3", "-1/7", "0/0", "a/b", "1/2/3", "1/4294967296"] {
            assert!(bad.parse::<Shard>().is_err(), "{bad}");
        }
    }
}
