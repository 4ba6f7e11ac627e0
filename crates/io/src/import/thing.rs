//! What scenes are built from, wherever it came from.

use super::model::{Half, Look, ModelPart};
use traylib_geometry::{Mesh, Primitive, SidedPrimitive, Sides, Vec3};
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

/// A shape with all that a scene wants to know of it.
pub(super) struct Thing {
    pub(super) shape: ObjectShape,
    pub(super) sides: Sides,
    pub(super) material: ThingMaterial,
    pub(super) emission: Rgb,
    /// Whether its other side is a thing of its own.
    pub(super) half: Half,
}

/// What a thing is made of.
#[derive(Clone, Copy, Debug)]
pub(super) enum ThingMaterial {
    /// The number of a named material.
    Named(usize),
    /// The number of a material of a file of shapes.
    Own(usize),
}

impl Thing {
    /// A part as its file has it, `first` being the number of the file's first
    /// material, and `glow` a factor on what it emits.
    pub(super) fn of_model(look: &Look, part: ModelPart, first: usize, glow: f32) -> Self {
        let sides = if part.half == Half::Whole { look.sides } else { Sides::Front };
        Self {
            shape: part.shape,
            sides,
            material: ThingMaterial::Own(first + part.look),
            emission: look.emission * glow,
            half: part.half,
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

    /// What rays can meet of it.
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
