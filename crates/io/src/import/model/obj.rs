//! Polygons and materials of OBJ files.

mod library;
mod material;
mod smoothing;
mod welder;

use super::beside::Beside;
use super::meshes::{Content, Piece};
use super::{Format, ModelFile, plain};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::textures::Textures;
use crate::load_options::LoadOptions;
use crate::obj::{self, Document};
use crate::source::Location;
use crate::{Error, Warning};
use material::MaterialImporter;
use welder::Welder;

/// Beside the file, what was repaired in its pictures.
pub(super) fn read(
    location: &Location,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let file = location.to_string();
    let failed = |cause| Error::Obj { file: file.clone(), cause };
    let bytes = location.read().map_err(|cause| Error::Read { file: file.clone(), cause })?;
    let document = obj::decode(&bytes, options.limits.obj()).map_err(failed)?;
    drop(bytes);
    if document.faces.is_empty() {
        return Err(Error::NothingToSee(file));
    }
    let beside = Beside::of(location, options);
    let (materials, warnings) = materials(&document, &beside, options, counter, &file)?;
    for (what, count) in document.warnings.iter() {
        counter.add_many(what, count);
    }
    let pieces = pieces(&document, materials.len() - 1, counter)
        .map_err(|cause| Error::Model { file, cause: cause.into() })?;
    Ok((ModelFile::of_meshes(Format::Obj, materials, Content::of_pieces(pieces)), warnings))
}

/// Those of the document in its order, and last that of faces without one.
fn materials(
    document: &Document,
    beside: &Beside,
    options: LoadOptions<'_>,
    counter: &mut Counter,
    file: &str,
) -> Result<(Vec<ImportedMaterial>, Vec<Warning>), Error> {
    let known = library::read(document, beside, options.limits.obj(), counter)?;
    let mut textures = Textures::new(options.limits);
    let mut importer = MaterialImporter { beside, textures: &mut textures, counter };
    let mut materials = Vec::with_capacity(document.materials.len() + 1);
    let failed = |cause| Error::Material { file: file.to_string(), cause };
    for name in &document.materials {
        let material = if let Some(material) = known.get(name) {
            importer.imported(material)
        } else {
            importer.counter.add(format!("material `{name}` not found, shown grey"));
            plain::material(name)
        };
        materials.push(material.map_err(failed)?);
    }
    materials.push(plain::material("").map_err(failed)?);
    Ok((materials, textures.into_warnings()))
}

/// The polygons as triangles, for each material those alike in what their corners have.
fn pieces(
    document: &Document,
    plain: usize,
    counter: &mut Counter,
) -> Result<Vec<Piece>, traylib_geometry::Error> {
    let mut welder = Welder::new(document);
    for face in &document.faces {
        welder.add(face);
    }
    let finished = |((material, _, _), arrays): (welder::Key, super::arrays::Arrays)| {
        let mesh = arrays.finish(counter)?;
        Ok(Piece { mesh, material: material.map_or(plain, |number| number as usize) })
    };
    welder.finish().into_iter().map(finished).collect()
}

#[cfg(test)]
mod tests;
