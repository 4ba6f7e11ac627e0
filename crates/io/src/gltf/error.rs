//! The reasons why bytes are no glTF.

use crate::Limit;

/// A file that makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Longer than [`Limits::bytes`](super::Limits::bytes).
    #[error("has more than {0} bytes; {more}", more = Limit::Bytes.remedy(*.0 as u64))]
    TooLong(usize),
    /// Neither JSON nor a binary glTF.
    #[error("it is no glTF: it begins neither with `{{` nor with `glTF`")]
    NotGltf,
    /// A binary glTF of another version.
    #[error("it is glTF of version {0}: 2 is read")]
    Version(String),
    /// The parts of a binary glTF make no sense.
    #[error("byte {byte}: {what}")]
    Container {
        /// The offset of the fault.
        byte: usize,
        /// The fault in words.
        what: &'static str,
    },
    /// The JSON text makes no sense.
    #[error("line {line}, column {column} of its JSON: {what}")]
    Json {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The fault in words.
        what: String,
    },
    /// An extension without which shapes are not known.
    #[error("it needs the extension `{0}`, which is not read")]
    Extension(String),
    /// A value makes no sense.
    #[error("{place}: {cause}")]
    Value {
        /// The place, as `meshes[0].primitives[1]`.
        place: String,
        /// The cause.
        cause: Cause,
    },
}

impl Error {
    pub(super) fn at(place: impl Into<String>, cause: Cause) -> Self {
        Self::Value { place: place.into(), cause }
    }
}

/// The reason why a value makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// An index of something that is not there.
    #[error("there is no {what} {index}: there are {count}")]
    OutOfRange {
        /// The kind of thing that it is an index of.
        what: &'static str,
        /// The index.
        index: u64,
        /// The number of things there are.
        count: usize,
    },
    /// There are fewer bytes than it needs.
    #[error("it needs {needed} bytes where there are {there}")]
    TooFewBytes {
        /// The number of bytes needed.
        needed: u64,
        /// The number of bytes there are.
        there: u64,
    },
    /// Elements lie more closely than they are long.
    #[error("a stride of {0} bytes is less than an element")]
    Stride(u64),
    /// Values of another type or kind than wanted.
    #[error("wanted is {0}")]
    Kind(&'static str),
    /// There are more or fewer of one than of the other.
    #[error("it has {given} elements where there are {wanted} positions")]
    Count {
        /// The number that is given.
        given: usize,
        /// The number that is wanted.
        wanted: usize,
    },
    /// A number is infinite or none.
    #[error("a number is infinite or not a number")]
    NotFinite,
    /// A node is reached twice.
    #[error("it is reached twice: nodes must be trees")]
    TwoParents,
    /// A buffer cannot be had.
    #[error("{0}")]
    Buffer(String),
    /// There is too much of something.
    #[error("there are more than {most} {what}; {}", .limit.remedy(*.most))]
    TooMany {
        /// The kind of thing that there is too much of.
        what: &'static str,
        /// The bound.
        most: u64,
        /// Its name.
        limit: Limit,
    },
}
