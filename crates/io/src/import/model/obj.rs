//! Polygons and materials of OBJ files.

mod library;
mod material;
mod smoothing;
mod welder;

use super::arrays::Arrays;
use super::beside::Beside;
use super::meshes::{Content, Piece};
use super::pictures::Pictures;
use super::source::ModelSource;
use super::{Format, ModelFile, plain};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::textures::Textures;
use crate::load_options::LoadOptions;
use crate::obj::mtl::Material;
use crate::obj::{self, Document, Face};
use crate::source::Location;
use crate::{Error, Warning};
use material::MaterialImporter;
use std::collections::HashMap;
use welder::Welder;

/// Reads a file with its libraries, and returns with it what was repaired in its pictures.
pub(super) fn read(
    location: &Location,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let source = ModelSource::new(location);
    let limits = options.limits.polygons();
    let document =
        obj::decode(&source.bytes()?, limits).map_err(|cause| source.malformed(cause))?;
    if document.faces.is_empty() {
        return Err(source.nothing_to_see());
    }
    let beside = Beside::of(location, options);
    let library = library::read(&document, &beside, limits, counter)?;
    let mut textures = Textures::new(options.limits);
    let pictures = Pictures { textures: &mut textures, counter };
    let materials = materials(&document, &library, MaterialImporter { beside: &beside, pictures })
        .map_err(|cause| source.bad_material(cause))?;
    counter.add_counts(&document.warnings);
    let pieces =
        pieces(&document, materials.len() - 1, counter).map_err(|cause| source.bad_mesh(cause))?;
    let content = Content::of_pieces(pieces);
    Ok((ModelFile::of_meshes(Format::Obj, materials, content), textures.into_warnings()))
}

/// Reads a file without its materials and smoothing groups: its polygons in triangles.
///
/// # Errors
/// It makes no sense, or has no face.
pub(super) fn bare(
    bytes: &[u8],
    limits: obj::Limits,
    counter: &mut Counter,
) -> Result<Arrays, String> {
    let document = obj::decode(bytes, limits).map_err(|cause| cause.to_string())?;
    if document.faces.is_empty() {
        return Err("it has no face that can be drawn".to_string());
    }
    counter.add_counts(&document.warnings);
    let mut welder = Welder::new(&document);
    for face in &document.faces {
        welder.add(&Face { material: None, smoothing: 0, ..*face });
    }
    Ok(welder.finish().into_values().fold(Arrays::default(), Arrays::joined))
}

/// Makes the materials of the document in its order, and last that of faces without one.
fn materials(
    document: &Document,
    library: &HashMap<String, Material>,
    mut importer: MaterialImporter<'_>,
) -> Result<Vec<ImportedMaterial>, traylib_materials::Error> {
    let mut materials = Vec::with_capacity(document.materials.len() + 1);
    for name in &document.materials {
        materials.push(if let Some(material) = library.get(name) {
            importer.imported(material)?
        } else {
            let what = format!("material `{name}` not found, shown grey");
            importer.pictures.counter.add(what);
            plain::material(name)?
        });
    }
    materials.push(plain::material("")?);
    Ok(materials)
}

/// Cuts the polygons into triangles, for each material those alike in what their corners have.
fn pieces(
    document: &Document,
    plain: usize,
    counter: &mut Counter,
) -> Result<Vec<Piece>, traylib_geometry::Error> {
    let mut welder = Welder::new(document);
    for face in &document.faces {
        welder.add(face);
    }
    let finished = |((material, _, _), arrays): (welder::Key, Arrays)| {
        let mesh = arrays.finish(counter)?;
        Ok(Piece { mesh, material: material.map_or(plain, |number| number as usize) })
    };
    welder.finish().into_iter().map(finished).collect()
}

#[cfg(test)]
mod tests;
