//! The warnings of the decoder: what it skips or repairs, counted by kind.

use crate::warning_counts::WarningCounts;
use std::fmt;

/// The kinds of what a reader skips or repairs in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum WarningKind {
    /// A chunk says it is longer than what holds it; cut to fit.
    ChunkCut,
    /// A chunk says it is shorter than its own header; the rest of what holds
    /// it is lost.
    ChunkTooShort,
    /// A list says it has more entries than there are bytes.
    ListCut,
    /// A chunk has fewer bytes than what it should hold.
    RecordCut,
    /// A number is infinite or not a number.
    NumberNotFinite,
    /// There are more items than the limit.
    TooManyItems,
    /// A face names a vertex that does not exist.
    FaceWithoutVertex,
    /// A face uses a vertex that is infinite or not a number.
    FaceNotFinite,
    /// A face has no area.
    FaceWithoutArea,
    /// A material group names a face that does not exist.
    GroupBeyondFaces,
    /// A face is in several material groups; the last one counts.
    FaceInTwoGroups,
    /// A material group names a material that does not exist.
    UnknownMaterial,
    /// The texture coordinates are not one per vertex.
    UvCount,
    /// A texture coordinate is infinite or not a number.
    UvNotFinite,
    /// A colour is infinite or not a number.
    ColourNotFinite,
    /// The local axes of a mesh cannot be undone.
    MatrixSingular,
    /// The local axes of a mesh make left of right.
    MatrixMirrored,
    /// A light stands at no place that can be told.
    LightWithoutPlace,
    /// A camera stands at, or looks to, no place that can be told.
    CameraWithoutPlace,
    /// A node hangs on one that does not exist.
    ParentUnknown,
    /// Nodes hang on one another in a loop.
    ParentLoop,
    /// A vertex joins faces of more smoothing masks than are told apart.
    TooManySmoothingMasks,
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ChunkCut => "chunk longer than what holds it, cut to fit",
            Self::ChunkTooShort => "chunk shorter than its header, the rest of its parent is lost",
            Self::ListCut => "list with fewer entries than it says",
            Self::RecordCut => "chunk shorter than what it should hold, not used",
            Self::NumberNotFinite => "number infinite or not a number, not used",
            Self::TooManyItems => {
                "mesh, material, light, camera, node or map beyond their greatest number, skipped \
                 (`--limit items=N` allows more)"
            }
            Self::FaceWithoutVertex => "face dropped: it names a vertex that does not exist",
            Self::FaceNotFinite => "face dropped: a vertex is infinite or not a number",
            Self::FaceWithoutArea => "face dropped: it has no area",
            Self::GroupBeyondFaces => "material given to a face that does not exist",
            Self::FaceInTwoGroups => "face with two materials, the last one counts",
            Self::UnknownMaterial => "material group of an unknown material, left grey",
            Self::UvCount => "mesh whose texture coordinates are not one per vertex",
            Self::UvNotFinite => "texture coordinate infinite or not a number, set to 0",
            Self::ColourNotFinite => "colour infinite or not a number, not used",
            Self::MatrixSingular => {
                "mesh whose local axes cannot be undone, taken as those of the world"
            }
            Self::MatrixMirrored => {
                "mesh with mirrored local axes, its vertices are used as stored"
            }
            Self::LightWithoutPlace => "light dropped: it stands at no place that can be told",
            Self::CameraWithoutPlace => "camera dropped: its place or target cannot be told",
            Self::ParentUnknown => "node hanging on one that does not exist, set free",
            Self::ParentLoop => "nodes hanging on one another in a loop, opened",
            Self::TooManySmoothingMasks => "vertex with too many smoothing masks, left flat",
        })
    }
}

/// Counts how often each kind was met.
pub type Warnings = WarningCounts<WarningKind>;
