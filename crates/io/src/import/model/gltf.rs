//! Meshes, materials, lights and cameras of glTF files.

mod material;

use super::arrays::Arrays;
use super::beside::Beside;
use super::meshes::{self, Content, Piece};
use super::pictures::Pictures;
use super::source::ModelSource;
use super::{Format, ModelFile};
use crate::gltf::{self, Camera, Document, Light, Primitive};
use crate::import::counter::Counter;
use crate::import::model_camera::{Fov, ModelCamera};
use crate::import::textures::Textures;
use crate::load_options::LoadOptions;
use crate::source::{Location, why};
use crate::{Error, Warning};
use material::MaterialImporter;
use traylib_geometry as geometry;
use traylib_scene::{PointLight, SpotCone};

/// Reads a file with its buffers, and returns with it what was repaired in its pictures.
pub(super) fn read(
    location: &Location,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let source = ModelSource::new(location);
    let beside = Beside::of(location, options);
    let mut load = |name: &str| buffer(&beside, name);
    let document = gltf::decode(&source.bytes()?, options.limits.gltf(), &mut load)
        .map_err(|cause| source.malformed(cause))?;
    counter.add_counts(&document.warnings);
    let has_triangles = |primitive: &Primitive| !primitive.triangles.is_empty();
    if document.instances.is_empty() || !document.primitives.iter().any(has_triangles) {
        return Err(source.nothing_to_see());
    }
    let mut textures = Textures::new(options.limits);
    let mut importer = MaterialImporter {
        file: &source.name,
        images: &document.images,
        beside: &beside,
        pictures: Pictures { textures: &mut textures, counter },
    };
    let materials =
        importer.all(&document.materials).map_err(|cause| source.bad_material(cause))?;
    let content =
        content(document, materials.len() - 1, counter).map_err(|cause| source.bad_mesh(cause))?;
    Ok((ModelFile::of_meshes(Format::Gltf, materials, content), textures.into_warnings()))
}

/// Reads a file beside the model; names that lead elsewhere are none.
fn buffer(beside: &Beside, name: &str) -> Result<Vec<u8>, String> {
    let shown = crate::suggest::shown(name);
    let location = beside.exactly(name).ok_or_else(|| {
        format!("there is no file `{shown}` in the folder, which its buffers must come from")
    })?;
    let bytes = location.read().map_err(|cause| format!("`{shown}`: {}", why(&cause)))?;
    Ok(bytes.into_owned())
}

fn content(
    document: Document,
    plain: usize,
    counter: &mut Counter,
) -> Result<Content, geometry::Error> {
    let camera = document.cameras.first().map(camera);
    if document.cameras.len() > 1 {
        counter.add_many("camera beside the first skipped", document.cameras.len() as u32 - 1);
    }
    let lights = document.lights.iter().filter_map(light).collect();
    let mut pieces = Vec::with_capacity(document.primitives.len());
    for primitive in document.primitives {
        let material = primitive.material.unwrap_or(plain);
        pieces.push(Piece { mesh: arrays(primitive).finish(counter)?, material });
    }
    let instance = |instance: &gltf::Instance| meshes::Instance {
        piece: instance.primitive,
        place: instance.place,
    };
    let instances = document.instances.iter().map(instance).collect();
    Ok(Content { pieces, instances, lights, camera })
}

fn arrays(primitive: Primitive) -> Arrays {
    let Primitive { positions, normals, mut uvs, triangles, .. } = primitive;
    // Ours goes up from the bottom of a picture.
    for uv in &mut uvs {
        uv.y = 1.0 - uv.y;
    }
    Arrays { positions, normals, uvs, triangles }
}

/// Makes a light of ours. Candela are taken for W/sr, as emission is for radiance.
fn light(light: &Light) -> Option<PointLight> {
    let cone = match light.cone {
        Some(angles) => {
            let [full, dark] = angles.map(f32::cos);
            Some(SpotCone::new(light.direction, full, dark).ok()?)
        }
        None => None,
    };
    let is_sound = light.position.is_finite();
    is_sound.then_some(PointLight { position: light.position, intensity: light.intensity, cone })
}

fn camera(camera: &Camera) -> ModelCamera {
    // As far as it is from the origin: nearer points would lose the direction in rounding.
    let far = camera.position.abs().max_element();
    let far = if far > 0.0 { far } else { 1.0 };
    ModelCamera {
        position: camera.position,
        target: camera.position + camera.direction * far,
        up: camera.up,
        fov: Fov::Vertical(camera.yfov.to_degrees()),
        aspect: camera.aspect,
        resolution: None,
    }
}

#[cfg(test)]
mod tests;
