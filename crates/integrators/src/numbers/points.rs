//! The points that are sampled in the space of all paths.

use std::fmt;
use std::str::FromStr;

/// The relation between the numbers of the paths of different passes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PointSet {
    /// No relation: every path has random numbers of its own.
    Independent,
    /// The first [pairs](traylib_math::sobol::PAIRS) of numbers of a path are a point of
    /// Sobol's sequence, which fills them more evenly from pass to pass; the rest is
    /// independent.
    #[default]
    Sobol,
}

/// Sequences that the passes of [`PointSet::Sobol`] belong to by turns. Each begins anew with
/// shifts of its own, so that their means are independent: passes of one sequence are not,
/// and tell nothing of the error.
pub(super) const SEQUENCES: u32 = 2;

impl PointSet {
    /// All, in the order in which they are listed.
    pub const ALL: [Self; 2] = [Self::Independent, Self::Sobol];

    /// Returns its name on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Independent => "independent",
            Self::Sobol => "sobol",
        }
    }

    /// Sequences of passes whose means are independent; one stands for passes that are.
    pub fn sequences(self) -> u32 {
        match self {
            Self::Independent => 1,
            Self::Sobol => SEQUENCES,
        }
    }
}

impl fmt::Display for PointSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for PointSet {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Self::ALL.into_iter().find(|set| set.name() == text).ok_or("wanted: independent or sobol")
    }
}
