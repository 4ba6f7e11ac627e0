//! The reasons why bytes are no polygon file.

use crate::Limit;
use crate::polygon_limits::PolygonFault;
use std::fmt;

/// A file that makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Longer than [`Limits::bytes`](super::Limits::bytes).
    #[error("has more than {0} bytes; {more}", more = Limit::Bytes.remedy(*.0 as u64))]
    TooLong(usize),
    /// It does not begin as one.
    #[error("it is no PLY file: it does not begin with `ply`")]
    NotPly,
    /// It has no end of the header.
    #[error("it ends before `end_header`")]
    HeaderEnds,
    /// The header makes no sense.
    #[error("line {line}: {cause}")]
    Header {
        /// The line, from 1.
        line: u32,
        /// The cause.
        cause: Cause,
    },
    /// The data after the header make no sense.
    #[error("{place}: {element} {number}: {cause}")]
    Data {
        /// The place.
        place: Place,
        /// The name of the element.
        element: String,
        /// Its number, from 0.
        number: usize,
        /// The cause.
        cause: Cause,
    },
    /// A polygon names a vertex that is not there.
    #[error("face {face}: there is no vertex {vertex}: there are {count}")]
    NoVertex {
        /// The number of the polygon that is kept, from 0.
        face: usize,
        /// The vertex.
        vertex: u32,
        /// The number of vertices there are.
        count: usize,
    },
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In this line of text, from 1.
    Line(u32),
    /// At this byte, from 0.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// The reason why something makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// A line of a header that is none.
    #[error("`{0}` is no line of a header")]
    Line(String),
    /// A format that is not known.
    #[error("`{0}` is no format: they are `ascii`, `binary_little_endian` and `binary_big_endian`")]
    Format(String),
    /// A header without a format before what it has.
    #[error("no format is named before")]
    NoFormat,
    /// A type that is not known.
    #[error("`{0}` is no type of a number")]
    Type(String),
    /// A property of no element.
    #[error("the property belongs to no element")]
    NoElement,
    /// Vertices lack a coordinate.
    #[error("vertices have no `{0}`")]
    NoCoordinate(&'static str),
    /// There are fewer bytes than its elements take.
    #[error("there cannot be {count} of them: {left} bytes are left")]
    TooFewBytes {
        /// The number that the header tells of.
        count: u64,
        /// The number of bytes that are left.
        left: usize,
    },
    /// The file ends.
    #[error("the file ends")]
    Ended,
    /// A word that should be a number.
    #[error("`{0}` is no number")]
    NotANumber(String),
    /// A coordinate that is infinite or none.
    #[error("a coordinate is infinite or not a number")]
    NotFinite,
    /// The length of a list that is none.
    #[error("{0} is no length of a list")]
    Length(String),
    /// The number of a vertex that is none.
    #[error("there is no vertex {0}")]
    Index(String),
    /// A polygon asks for too much.
    #[error(transparent)]
    Polygon(#[from] PolygonFault),
    /// There are more of something than can be numbered.
    #[error("there are too many {0}")]
    TooMany(&'static str),
}
