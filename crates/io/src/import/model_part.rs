//! Pieces of files of shapes, each with one material.

use traylib_scene::ObjectShape;

/// A shape of a file with the material and the sides it stands for.
#[derive(Debug)]
pub(super) struct ModelPart {
    pub(super) shape: ObjectShape,
    /// Index into the file's materials.
    pub(super) material: usize,
    pub(super) side: ModelSide,
}

/// The part of a surface that an object stands for. Surfaces emit from their fronts only, so that
/// one which emits from both sides becomes two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ModelSide {
    /// All of it.
    Whole,
    /// Its front, the back apart.
    Front,
    /// Its back, turned round.
    Back,
}
