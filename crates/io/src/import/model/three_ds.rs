//! Meshes, materials, lights and cameras of 3DS files.

mod light;
mod maps;
mod material;
mod skipped;
mod welder;

use super::folder::Folder;
use super::pictures::Pictures;
use super::source::ModelSource;
use super::{Format, ModelFile};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::model_camera::{Fov, ModelCamera};
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::placement::Placement;
use crate::import::textures::Textures;
use crate::source::Location;
use crate::three_ds::smoothing::corner_normals;
use crate::three_ds::{self, Document, Mesh, pose};
use crate::{Error, ReadLimits, Warning};
use maps::MapImporter;
use std::collections::BTreeMap;
use traylib_geometry::{self as geometry, Aabb};
use traylib_math::Vec3;
use traylib_scene::{ObjectShape, PointLight};
use welder::Welder;

/// The contents of a file before they are placed.
pub(super) struct Content {
    meshes: Vec<Mesh>,
    /// For each mesh, the unit normals of its faces' corners.
    normals: Vec<Option<Vec<[Vec3; 3]>>>,
    lights: Vec<three_ds::Light>,
    camera: Option<ModelCamera>,
    /// The number of the material of faces that name none.
    plain: usize,
}

/// Reads a file, and returns with it what was repaired in its pictures.
pub(super) fn read(
    location: &Location,
    limits: ReadLimits,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let source = ModelSource::new(location);
    let document = three_ds::decode_within(&source.bytes()?, limits.three_ds())
        .map_err(|cause| source.malformed(cause))?;
    if document.meshes.iter().all(|mesh| mesh.faces.is_empty()) {
        return Err(source.nothing_to_see());
    }
    let mut textures = Textures::new(limits);
    let folder = Folder::of(location);
    let pictures = Pictures { textures: &mut textures, counter };
    let model = model(document, &mut MapImporter { folder, pictures })
        .map_err(|cause| source.bad_material(cause))?;
    Ok((model, textures.into_warnings()))
}

fn model(
    document: Document,
    importer: &mut MapImporter<'_>,
) -> Result<ModelFile, traylib_materials::Error> {
    let plain = three_ds::Material::default();
    let materials = document.materials.iter().chain([&plain]);
    let materials = materials.map(|material| material::imported(material, importer));
    let materials: Vec<ImportedMaterial> = materials.collect::<Result<_, _>>()?;
    let counter = &mut *importer.pictures.counter;
    let content = Content::new(document, materials.len() - 1, counter);
    let content = super::Content::ThreeDs(content);
    Ok(ModelFile { materials, format: Format::ThreeDs, content })
}

impl Content {
    fn new(document: Document, plain: usize, counter: &mut Counter) -> Self {
        let skipped = skipped::skipped(&document);
        let meshes = meshes(&document);
        let camera = document.cameras.iter().find_map(camera);
        let mut warnings = document.warnings;
        let normals = meshes.iter().map(|mesh| corner_normals(mesh, &mut warnings)).collect();
        counter.add_counts(&warnings);
        for (what, count) in skipped {
            counter.add_many(what, count);
        }
        Self { meshes, normals, lights: document.lights, camera, plain }
    }

    /// The file's meshes where they go, split by material.
    pub(super) fn parts(&self, placement: &Placement) -> Result<Vec<ModelPart>, geometry::Error> {
        let mut parts = Vec::new();
        for (mesh, normals) in self.meshes.iter().zip(&self.normals) {
            for (material, faces) in self.faces_by_material(mesh) {
                let mut welder = Welder::new(mesh, normals.as_deref(), placement);
                let triangles = faces.into_iter().map(|face| welder.triangle(face)).collect();
                let shape = ObjectShape::Mesh(welder.finish(triangles)?);
                parts.push(ModelPart { shape, material, side: ModelSide::Whole });
            }
        }
        Ok(parts)
    }

    /// Lets go of its shapes.
    pub(super) fn forget_shapes(&mut self) {
        (self.meshes, self.normals) = (Vec::new(), Vec::new());
    }

    fn faces_by_material(&self, mesh: &Mesh) -> BTreeMap<usize, Vec<usize>> {
        let mut materials: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (index, face) in mesh.faces.iter().enumerate() {
            materials.entry(face.material.unwrap_or(self.plain)).or_default().push(index);
        }
        materials
    }

    pub(super) fn lights(&self, placement: &Placement, around: &Aabb) -> Vec<PointLight> {
        self.lights.iter().filter_map(|light| light::light(light, placement, around)).collect()
    }

    pub(super) fn light_count(&self) -> usize {
        self.lights.len()
    }

    pub(super) fn camera(&self) -> Option<ModelCamera> {
        self.camera
    }
}

/// The meshes that are shown, as stored, and once more for each further place of
/// them.
fn meshes(document: &Document) -> Vec<Mesh> {
    let shown = |placed: &pose::Placed| pose::is_shown(document, placed);
    let placed = |placed: pose::Placed| {
        let mesh = &document.meshes[placed.mesh];
        let stays = placed.place == three_ds::Affine::IDENTITY;
        if stays { mesh.clone() } else { mesh.placed(&placed.place) }
    };
    pose::stored_with_instances(document).into_iter().filter(shown).map(placed).collect()
}

fn camera(camera: &three_ds::Camera) -> Option<ModelCamera> {
    let (position, target, up) = (camera.position, camera.target, camera.up()?);
    let fov = Fov::Horizontal(camera.fov_degrees());
    Some(ModelCamera { position, target, up, fov, aspect: None, resolution: None })
}

#[cfg(test)]
mod tests;
