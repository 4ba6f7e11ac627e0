//! The parts of a file that the decoder skips.

use std::fmt;

/// The kinds of what is skipped.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum WarningKind {
    /// An element that is not known here.
    Element(String),
    /// A value that belongs to no object.
    Stray(String),
    /// A step of a transform that is not known.
    Step(String),
    /// A rotation about a vector that is not of length one, for which Mitsuba 3.9.1 scales, too.
    Axis,
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Element(tag) => write!(f, "element `{tag}` skipped"),
            Self::Stray(tag) => write!(f, "`{tag}` that belongs to no object skipped"),
            Self::Axis => {
                f.write_str("axis of a `rotate` that is not of length one, brought there")
            }
            Self::Step(tag) => write!(f, "`{tag}` in a transform skipped"),
        }
    }
}
