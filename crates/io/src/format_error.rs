//! Errors of the bytes of a file of shapes.

/// The error of the decoder of one format.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(transparent)]
#[non_exhaustive]
pub enum FormatError {
    /// 3D Studio.
    ThreeDs(#[from] crate::three_ds::Error),
    /// Wavefront, object files as well as material libraries.
    Obj(#[from] crate::obj::Error),
    /// Stanford's polygons.
    Ply(#[from] crate::ply::Error),
    /// Khronos' format.
    Gltf(#[from] crate::gltf::Error),
}
