//! The errors of this crate: what cannot be built, and why.

use std::fmt;

/// The reason why a shape, a mesh or a hierarchy was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// A coordinate or a length is infinite or not a number.
    NotFinite,
    /// The area is zero, or too small or too large for its reciprocal to be a
    /// number.
    NoArea,
    /// A radius is zero or negative; of several, one is negative or all are
    /// zero.
    NoRadius,
    /// The two ends of an axis are one point.
    NoAxis,
    /// A normal has no direction.
    NoNormal,
    /// A triangle names a position that does not exist.
    MissingPosition {
        /// The triangle.
        triangle: usize,
        /// The position it asks for.
        index: u32,
    },
    /// Normals or texture coordinates are not as many as the positions.
    WrongCount {
        /// The number of positions.
        positions: usize,
        /// The number of values that were given.
        given: usize,
    },
    /// A shape has bounds that are infinite or not numbers.
    UnboundedShape {
        /// Its place in the list.
        index: usize,
    },
    /// More than 2²⁷ shapes, or 2³² triangles.
    TooMany,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite => write!(f, "a coordinate is infinite or not a number"),
            Self::NoArea => write!(f, "the shape has no area, or one beyond all measure"),
            Self::NoRadius => write!(f, "the radius is not positive"),
            Self::NoAxis => write!(f, "the ends of the axis are the same point"),
            Self::NoNormal => write!(f, "the normal has length zero"),
            Self::MissingPosition { triangle, index } => {
                write!(f, "triangle {triangle} names position {index}, which does not exist")
            }
            Self::WrongCount { positions, given } => {
                write!(f, "{given} values were given for {positions} positions")
            }
            Self::UnboundedShape { index } => {
                write!(f, "shape {index} has bounds that are infinite or not numbers")
            }
            Self::TooMany => write!(f, "more shapes than can be numbered"),
        }
    }
}

impl std::error::Error for Error {}
