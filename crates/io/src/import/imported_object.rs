//! Objects that scenes are built from, whatever file they came from.

use super::imported_material::ImportedMaterial;
use super::model_part::{ModelPart, ModelSide};
use traylib_geometry::{Mesh, Primitive, SidedPrimitive, Sides, Vec3};
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

/// A shape with all that a scene wants to know of it.
pub(super) struct ImportedObject {
    pub(super) shape: ObjectShape,
    pub(super) sides: Sides,
    pub(super) material: ObjectMaterial,
    pub(super) emission: Rgb,
    /// The sides that it stands for: of a lamp of two sides, each is an object of its own.
    pub(super) side: ModelSide,
}

/// The material of an object, by its number.
#[derive(Clone, Copy, Debug)]
pub(super) enum ObjectMaterial {
    /// The number of a named material.
    Named(usize),
    /// The number of a material of a file of shapes.
    Own(usize),
}

impl ImportedObject {
    /// A part as its file has it, `first` being the number of the file's first
    /// material, and `glow` a factor on what it emits.
    pub(super) fn of_model(
        material: &ImportedMaterial,
        part: ModelPart,
        first: usize,
        glow: f32,
    ) -> Self {
        let sides = if part.side == ModelSide::Whole { material.sides } else { Sides::Front };
        Self {
            shape: part.shape,
            sides,
            material: ObjectMaterial::Own(first + part.material),
            emission: material.emission * glow,
            side: part.side,
        }
    }

    /// Points that hold it.
    pub(super) fn extremes(&self) -> Vec<Vec3> {
        match &self.shape {
            ObjectShape::Primitive(primitive) => {
                let bounds = primitive.bounds();
                vec![bounds.min, bounds.max]
            }
            ObjectShape::Mesh(mesh) => mesh.positions().to_vec(),
        }
    }

    /// Returns the primitives of it that rays can meet.
    pub(super) fn primitives(&self) -> impl Iterator<Item = SidedPrimitive> {
        let (single, mesh) = match &self.shape {
            ObjectShape::Primitive(primitive) => (Some(*primitive), None),
            ObjectShape::Mesh(mesh) => (None, Some(mesh)),
        };
        let triangles = mesh.into_iter().flat_map(triangles);
        let sides = self.sides;
        single
            .into_iter()
            .chain(triangles)
            .map(move |primitive| SidedPrimitive { primitive, sides })
    }
}

fn triangles(mesh: &Mesh) -> impl Iterator<Item = Primitive> {
    (0..mesh.triangle_count()).filter_map(|index| mesh.triangle(index)).map(Primitive::Triangle)
}
