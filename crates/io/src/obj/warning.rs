//! The warnings of the decoders: what they skip or repair.

use std::fmt;

/// The kinds of what a reader skips or repairs in a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum WarningKind {
    /// A vertex has a colour.
    VertexColour,
    /// A vertex has a weight other than one.
    VertexWeight,
    /// A texture coordinate is infinite or not a number.
    UvNotFinite,
    /// A normal is infinite or not a number.
    NormalNotFinite,
    /// Points and lines.
    PointOrLine,
    /// Curves and surfaces of free form.
    FreeForm,
    /// A polygon of less than three corners.
    TooFewCorners,
    /// A smoothing group that is no number.
    SmoothingGroup,
    /// A colour that is given by a spectrum or in CIE XYZ.
    Spectrum,
    /// A halo of dissolve.
    Halo,
    /// An option of a map.
    MapOption(String),
    /// Another statement.
    Statement(String),
    /// Another statement whose name is none.
    Nameless,
}

impl WarningKind {
    /// Makes the warning of a statement that is not known.
    pub(super) fn statement(keyword: &[u8]) -> Self {
        name(keyword).map_or(Self::Nameless, Self::Statement)
    }

    /// Makes the warning of an option that is not known.
    pub(super) fn option(word: &str) -> Self {
        name(word.as_bytes()).map_or(Self::Nameless, Self::MapOption)
    }
}

/// Returns a word that may be shown: short, and of letters.
fn name(word: &[u8]) -> Option<String> {
    let is_name = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-');
    let text = std::str::from_utf8(word).ok()?;
    (text.len() <= 20 && word.iter().all(is_name)).then(|| text.to_string())
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::VertexColour => "colour of a vertex skipped",
            Self::VertexWeight => "weight of a vertex skipped",
            Self::UvNotFinite => "texture coordinate infinite or not a number, set to 0",
            Self::NormalNotFinite => "normal infinite or not a number, not used",
            Self::PointOrLine => "points or lines skipped",
            Self::FreeForm => "statement of a free-form curve or surface skipped",
            Self::TooFewCorners => "face dropped: it has less than three corners",
            Self::SmoothingGroup => "smoothing group that is no number, taken for none",
            Self::Spectrum => "colour as a spectrum or in CIE XYZ skipped",
            Self::Halo => "halo of `d` taken for even opacity",
            Self::MapOption(name) => return write!(f, "option `{name}` of a map skipped"),
            Self::Statement(name) => return write!(f, "statement `{name}` skipped"),
            Self::Nameless => "line that begins with no name of a statement skipped",
        })
    }
}
