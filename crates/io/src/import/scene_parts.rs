//! The parts that a scene is built of, whatever files it came from.

use super::imported_object::{ImportedObject, ObjectMaterial};
use crate::load_options::SceneSettings;
use std::sync::Arc;
use traylib_geometry::Sides;
use traylib_materials::{Material, Texture};
use traylib_math::Rgb;
use traylib_scene::{CameraSettings, ObjectShape, PointLight};

/// All of a scene before it is built.
#[derive(Debug)]
pub(crate) struct SceneParts {
    pub(crate) camera: CameraSettings,
    pub(crate) settings: SceneSettings,
    /// Materials with their names, which may be empty or those of others, too.
    pub(crate) materials: Vec<(String, Material)>,
    pub(crate) objects: Vec<PartObject>,
    pub(crate) lights: Vec<PointLight>,
    pub(crate) sky: Option<PartSky>,
}

/// The sky of a scene.
#[derive(Debug, PartialEq)]
pub(crate) struct PartSky {
    /// Its radiance, row by row from the top; one texel if it is the same everywhere.
    pub(crate) radiance: Arc<Texture>,
    pub(crate) turn_degrees: f32,
}

/// An object of a scene.
#[derive(Debug)]
pub(crate) struct PartObject {
    pub(crate) shape: ObjectShape,
    pub(crate) sides: Sides,
    /// Index of its material.
    pub(crate) material: usize,
    pub(crate) emission: Rgb,
}

impl PartObject {
    /// The object that an imported one becomes, `named` materials being before those of files;
    /// `None` of a mesh without area.
    pub(super) fn of(item: &ImportedObject, named: usize) -> Option<Self> {
        let shape = match &item.shape {
            ObjectShape::Primitive(primitive) => ObjectShape::Primitive(*primitive),
            ObjectShape::Mesh(mesh) => {
                let mesh = mesh.clone().without_degenerate();
                (mesh.triangle_count() > 0).then_some(ObjectShape::Mesh(mesh))?
            }
        };
        let material = match item.material {
            ObjectMaterial::Named(index) => index,
            ObjectMaterial::Own(index) => named + index,
        };
        Some(Self { shape, sides: item.sides, material, emission: item.emission })
    }
}
