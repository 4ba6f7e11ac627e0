//! The warnings of the decoder: what it skips or repairs.

use std::fmt;

/// The kinds of what a reader skips or repairs in a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum WarningKind {
    /// A line of the header that is none.
    HeaderLine,
    /// A vertex has a colour.
    VertexColour,
    /// A face has a colour.
    FaceColour,
    /// A texture coordinate is infinite or not a number.
    UvNotFinite,
    /// A normal is infinite or not a number.
    NormalNotFinite,
    /// Texture coordinates of a face that are not one for each of its corners.
    UvCount,
    /// A polygon of less than three corners.
    TooFewCorners,
    /// A face with another picture than the first.
    OtherPicture,
    /// Another property of vertices.
    VertexProperty(String),
    /// Another property of faces.
    FaceProperty(String),
    /// Another element.
    Element(String),
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::HeaderLine => "line of the header that is none skipped",
            Self::VertexColour => "colour of a vertex skipped",
            Self::FaceColour => "colour of a face skipped",
            Self::UvNotFinite => "texture coordinate infinite or not a number, set to 0",
            Self::NormalNotFinite => "normal infinite or not a number, not used",
            Self::UvCount => "face whose texture coordinates are not one for each corner, set to 0",
            Self::TooFewCorners => "face dropped: it has less than three corners",
            Self::OtherPicture => "face with another picture than the first, shown with that",
            Self::VertexProperty(name) => {
                return write!(f, "property `{name}` of vertices skipped");
            }
            Self::FaceProperty(name) => return write!(f, "property `{name}` of faces skipped"),
            Self::Element(name) => return write!(f, "element `{name}` skipped"),
        })
    }
}
