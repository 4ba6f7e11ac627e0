//! The reasons why bytes are no object file or material library.

use crate::Limit;
use crate::polygon_limits::PolygonFault;

/// A file that makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Longer than [`Limits::bytes`](super::Limits::bytes).
    #[error("has more than {0} bytes; {more}", more = Limit::Bytes.remedy(*.0 as u64))]
    TooLong(usize),
    /// Text that is no sequence of bytes.
    #[error("it is UTF-16 text: save it as UTF-8")]
    Utf16,
    /// A statement makes no sense.
    #[error("line {line}: {cause}")]
    Line {
        /// The line in which it begins, from 1.
        line: u32,
        /// The cause.
        cause: Cause,
    },
}

/// The reason why a statement makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// A word that should be a number.
    #[error("`{0}` is no number")]
    NotANumber(String),
    /// A coordinate or another number that is infinite or none.
    #[error("`{0}` is infinite or not a number")]
    NotFinite(String),
    /// Too few words.
    #[error("`{keyword}` wants {wanted}")]
    Missing {
        /// The statement.
        keyword: &'static str,
        /// The words that it wants.
        wanted: &'static str,
    },
    /// A corner that is none.
    #[error("`{0}` is no corner: wanted are numbers of vertex, texture coordinate and normal")]
    NotACorner(String),
    /// A number of something that is not there.
    #[error("there is no {what} {number}: there are {count} so far")]
    OutOfRange {
        /// The kind of thing that it is a number of.
        what: &'static str,
        /// The number as it stands there.
        number: i64,
        /// The number of things there are.
        count: usize,
    },
    /// A polygon asks for too much.
    #[error(transparent)]
    Polygon(#[from] PolygonFault),
    /// There are more of something than can be numbered.
    #[error("there are too many {0}")]
    TooMany(&'static str),
}
