//! The warnings of the decoder: what it skips or repairs.

use std::fmt;

/// The kinds of what a reader skips or repairs in a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum WarningKind {
    /// Animations.
    Animation,
    /// Scenes beside the one that is shown.
    Scene,
    /// A skin, which moves vertices with bones.
    Skin,
    /// Targets into which a mesh may change.
    MorphTarget,
    /// Colours of a vertex.
    VertexColour,
    /// Points or lines.
    PointsOrLines,
    /// Normals that are infinite or none.
    NormalNotFinite,
    /// Texture coordinates that are infinite or none.
    UvNotFinite,
    /// A light that shines from everywhere alike.
    DirectionalLight,
    /// A light that ends at a distance.
    LightRange,
    /// A light whose numbers make no sense.
    OddLight,
    /// A camera without perspective.
    Orthographic,
    /// A camera whose place or angle of view makes no sense.
    OddCamera,
    /// A number of a material that is not from 0 to 1.
    OutsideUnit,
    /// An extension.
    Extension(String),
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Animation => "animation skipped, everything stands as stored",
            Self::Scene => "scene beside the one that is shown skipped",
            Self::Skin => "skin of a mesh skipped, it is shown as stored",
            Self::MorphTarget => "form into which a mesh may change skipped",
            Self::VertexColour => "colour of a vertex skipped",
            Self::PointsOrLines => "points or lines skipped",
            Self::NormalNotFinite => "normal infinite or not a number, not used",
            Self::UvNotFinite => "texture coordinate infinite or not a number, set to 0",
            Self::DirectionalLight => "light from far away (`directional`) skipped",
            Self::LightRange => "range of a light skipped, it shines on",
            Self::OddLight => "light whose numbers make no sense skipped",
            Self::Orthographic => "camera without perspective skipped",
            Self::OddCamera => "camera whose place or angle makes no sense skipped",
            Self::OutsideUnit => "number of a material not from 0 to 1, brought there",
            Self::Extension(name) => return write!(f, "extension `{name}` skipped"),
        })
    }
}
