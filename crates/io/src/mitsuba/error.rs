//! Why a file is no scene.

use crate::Limit;

/// A fault and where it is.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}:{line}:{column}: {fault}")]
pub struct Error {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: u32,
    /// The character in it, from 1.
    pub column: u32,
    /// The fault at that place.
    pub fault: Fault,
}

/// The faults that a file can have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The bytes are no text.
    #[error("it is not UTF-8 text: save it as UTF-8")]
    NotText,
    /// The text is no XML.
    #[error("{0}")]
    Xml(String),
    /// It has a document type.
    #[error("a document type (`<!DOCTYPE`), which is not read")]
    DocumentType,
    /// It does not begin as a scene does.
    #[error("`{0}` where `scene` was expected: it is no scene of Mitsuba")]
    NoScene(String),
    /// An element lacks what it cannot do without.
    #[error("`{element}` has no `{attribute}`")]
    Missing {
        /// The element.
        element: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// Text that should be something else.
    #[error("`{text}` is not {expected}")]
    Unreadable {
        /// The text.
        text: String,
        /// The kind of value that was expected.
        expected: &'static str,
    },
    /// A parameter that has no value.
    #[error("no `default` gives a value to `{0}`")]
    Undefined(String),
    /// A reference to nothing.
    #[error("nothing has the id `{0}`")]
    NoSuchId(String),
    /// An id that has been given away.
    #[error("a second object has the id `{0}`")]
    SecondId(String),
    /// Objects that are within themselves.
    #[error("`{0}` is within itself, or within more objects than make sense")]
    Circle(String),
    /// An included file cannot be had.
    #[error("`{name}` cannot be included: {why}")]
    Include {
        /// Its name.
        name: String,
        /// Why.
        why: String,
    },
    /// The file of a shape cannot be had or makes no sense.
    #[error("`{name}` cannot be used: {why}")]
    Shape {
        /// Its name.
        name: String,
        /// Why.
        why: String,
    },
    /// A material that cannot be rendered.
    #[error("`{kind}`: {why}")]
    Material {
        /// Its type.
        kind: String,
        /// Why.
        why: String,
    },
    /// More than a file may ask for whatever its reader allows.
    #[error("more than {limit} {what}")]
    TooMany {
        /// The kind of thing that there are too many of.
        what: &'static str,
        /// The bound.
        limit: usize,
    },
    /// A bound of the reader is exceeded.
    #[error("more than {limit} {what}; {}", .option.remedy(*.limit))]
    Limit {
        /// The kind of thing that there are too many of.
        what: &'static str,
        /// The bound.
        limit: u64,
        /// Its name.
        option: Limit,
    },
}
