//! Polygons of PLY files: one material, grey or with the picture that the file names.

use super::arrays::Arrays;
use super::beside::Beside;
use super::meshes::{Content, Piece};
use super::pictures::Pictures;
use super::source::ModelSource;
use super::{Format, ModelFile, plain};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::textures::{Meaning, Textures, Usage};
use crate::load_options::LoadOptions;
use crate::ply::{self, Document};
use crate::source::Location;
use crate::{Error, Warning, polygon};
use std::collections::HashMap;
use traylib_materials::{Layer, Maps};

/// Reads a file, and returns with it what was repaired in its picture.
pub(super) fn read(
    location: &Location,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let source = ModelSource::new(location);
    let document = ply::decode(&source.bytes()?, options.limits.polygons())
        .map_err(|cause| source.malformed(cause))?;
    if document.counts.is_empty() {
        return Err(source.nothing_to_see());
    }
    counter.add_counts(&document.warnings);
    let mut textures = Textures::new(options.limits);
    let beside = Beside::of(location, options);
    let mut pictures = Pictures { textures: &mut textures, counter };
    let material =
        material(&document, &beside, &mut pictures).map_err(|cause| source.bad_material(cause))?;
    let mesh = arrays(document).finish(counter).map_err(|cause| source.bad_mesh(cause))?;
    let content = Content::of_pieces(vec![Piece { mesh, material: 0 }]);
    Ok((ModelFile::of_meshes(Format::Ply, vec![material], content), textures.into_warnings()))
}

/// Reads a file without its picture: its polygons in triangles.
///
/// # Errors
/// It makes no sense, or has no face.
pub(super) fn bare(
    bytes: &[u8],
    limits: ply::Limits,
    counter: &mut Counter,
) -> Result<Arrays, String> {
    let document = ply::decode(bytes, limits).map_err(|cause| cause.to_string())?;
    if document.counts.is_empty() {
        return Err("it has no face that can be drawn".to_string());
    }
    counter.add_counts(&document.warnings);
    Ok(arrays(document))
}

/// Makes the only material: grey, or the first picture that the file names.
fn material(
    document: &Document,
    beside: &Beside,
    pictures: &mut Pictures<'_>,
) -> Result<ImportedMaterial, traylib_materials::Error> {
    let mut material = plain::material("")?;
    let has_uvs = !(document.uvs.is_empty() && document.corner_uvs.is_empty());
    if let Some(name) = document.textures.first().filter(|_| has_uvs) {
        let picture = pictures.load(name, beside.find(name), Usage::plain(Meaning::Colour));
        let maps = |texture| Maps { diffuse: Some(Layer::new(texture)), ..Maps::default() };
        material.surface.maps = picture.map(|texture| Box::new(maps(texture)));
    }
    Ok(material)
}

/// Cuts the polygons into triangles.
fn arrays(document: Document) -> Arrays {
    let vertices = Vertices::of(&document);
    let Document { positions, normals, .. } = &document;
    let mut triangles = Vec::with_capacity(document.corners.len() / 3);
    for (first, corners) in document.faces() {
        let number = |corner: usize| vertices.number(first + corner, corners[corner]);
        if corners.len() == 3 {
            triangles.push([0, 1, 2].map(number));
            continue;
        }
        let outline = || corners.iter().map(|&corner| positions[corner as usize].as_dvec3());
        let cut = polygon::cut(outline(), polygon::newell(outline()));
        triangles.extend(cut.into_iter().map(|triangle| triangle.map(number)));
    }
    match vertices {
        Vertices::AsTheyAre => Arrays {
            positions: document.positions,
            normals: document.normals,
            uvs: document.uvs,
            triangles,
        },
        Vertices::Split { from, uvs, .. } => {
            let positions = from.iter().map(|&vertex| positions[vertex as usize]).collect();
            let normals = from.iter().filter_map(|&vertex| normals.get(vertex as usize).copied());
            let normals = normals.collect();
            Arrays { positions, normals, uvs, triangles }
        }
    }
}

/// The vertices of triangles.
enum Vertices {
    /// They are those of the file.
    AsTheyAre,
    /// One for each vertex and texture coordinates that meet in a corner.
    Split {
        /// The number of the vertex of each corner.
        numbers: Vec<u32>,
        /// The vertex of the file.
        from: Vec<u32>,
        uvs: Vec<traylib_math::Vec2>,
    },
}

impl Vertices {
    fn of(document: &Document) -> Self {
        if document.corner_uvs.len() != document.corners.len() {
            return Self::AsTheyAre;
        }
        let (mut known, mut from, mut uvs) = (HashMap::new(), Vec::new(), Vec::new());
        let numbered = |(&vertex, uv): (&u32, &traylib_math::Vec2)| {
            *known.entry((vertex, uv.to_array().map(f32::to_bits))).or_insert_with(|| {
                from.push(vertex);
                uvs.push(*uv);
                from.len() as u32 - 1
            })
        };
        let numbers = document.corners.iter().zip(&document.corner_uvs).map(numbered).collect();
        Self::Split { numbers, from, uvs }
    }

    /// The number of a corner, which is this vertex in the file.
    fn number(&self, corner: usize, vertex: u32) -> u32 {
        match self {
            Self::AsTheyAre => vertex,
            Self::Split { numbers, .. } => numbers[corner],
        }
    }
}

#[cfg(test)]
mod tests;
