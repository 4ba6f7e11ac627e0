//! Decoder of 3D Studio files (`.3ds`, releases 3 and 4).
//!
//! Bytes become a [`Document`]: meshes with their faces, smoothing masks and
//! materials, all as stored. Vertices are in world space already; the local
//! matrix of a mesh is not applied. The file has no unit; z is up and the front
//! of a face is the side from which its corners turn counter-clockwise.
//!
//! Not read: keyframer, lights, cameras, texture and bump maps. What is skipped
//! or repaired is counted in [`Warnings`].
//!
//! Sources: the chunk layout as published with lib3ds 1.3 and 2.0.

mod chunk;
mod material;
mod mesh;
pub mod smoothing;
mod warning;
mod wide;

pub use material::{Material, Shading};
pub use mesh::{Face, Mesh};
pub use warning::{WarningKind, Warnings};

use chunk::Reader;
use mesh::RawMesh;
use std::collections::HashMap;

/// What a 3DS file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Every mesh with at least one face that can be drawn, in file order.
    pub meshes: Vec<Mesh>,
    /// The materials in file order. Names may repeat; the first one counts.
    pub materials: Vec<Material>,
    /// What was skipped or repaired.
    pub warnings: Warnings,
}

/// Why bytes are not a 3DS file. Damage further inside is a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Shorter than the six bytes of a chunk header.
    #[error("ends after {0} bytes, a 3DS file has at least 6")]
    TooShort(usize),
    /// The first chunk is not one a 3DS file begins with.
    #[error("starts with chunk {0:#06x} at @0x0, a 3DS file with 0x4d4d, 0x3daa or 0xc23d")]
    NotThreeDs(u16),
}

const ROOTS: [u16; 3] = [0x4d4d, 0x3daa, 0xc23d];
const MESH_DATA: u16 = 0x3d3d;
const MATERIAL: u16 = 0xafff;
const OBJECT: u16 = 0x4000;
const TRIANGLES: u16 = 0x4100;
const LIGHT: u16 = 0x4600;
const CAMERA: u16 = 0x4700;
const KEYFRAMER: u16 = 0xb000;

/// Decodes a file.
///
/// Memory stays within a fixed multiple of the size of `bytes`.
///
/// # Errors
/// If the bytes do not begin as a 3DS file does.
pub fn decode(bytes: &[u8]) -> Result<Document, Error> {
    let mut warnings = Warnings::default();
    let (id, root) =
        Reader::new(bytes).next_chunk(&mut warnings).ok_or(Error::TooShort(bytes.len()))?;
    if !ROOTS.contains(&id) {
        return Err(Error::NotThreeDs(id));
    }
    let mut decoder = Decoder { materials: Vec::new(), meshes: Vec::new(), warnings };
    decoder.section(root);
    Ok(decoder.finish())
}

struct Decoder {
    materials: Vec<Material>,
    meshes: Vec<RawMesh>,
    warnings: Warnings,
}

impl Decoder {
    /// The root or the mesh section: some writers put materials and objects
    /// directly under the root.
    fn section(&mut self, mut reader: Reader<'_>) {
        while let Some((id, body)) = reader.next_chunk(&mut self.warnings) {
            match id {
                MESH_DATA => self.mesh_data(body),
                _ => self.item(id, body),
            }
        }
    }

    fn mesh_data(&mut self, mut reader: Reader<'_>) {
        while let Some((id, body)) = reader.next_chunk(&mut self.warnings) {
            self.item(id, body);
        }
    }

    fn item(&mut self, id: u16, body: Reader<'_>) {
        match id {
            MATERIAL => self.materials.push(material::decode(body, &mut self.warnings)),
            OBJECT => self.object(body),
            KEYFRAMER => self.warnings.add(WarningKind::KeyframerSkipped),
            _ => {}
        }
    }

    fn object(&mut self, mut reader: Reader<'_>) {
        let name = reader.string();
        while let Some((id, body)) = reader.next_chunk(&mut self.warnings) {
            match id {
                TRIANGLES => {
                    let mesh = RawMesh::decode(name.clone(), body, &mut self.warnings);
                    self.meshes.push(mesh);
                }
                LIGHT => self.warnings.add(WarningKind::LightSkipped),
                CAMERA => self.warnings.add(WarningKind::CameraSkipped),
                _ => {}
            }
        }
    }

    /// Material names are resolved last: they may be used before they are
    /// defined.
    fn finish(mut self) -> Document {
        let names = MaterialNames::new(&self.materials);
        let meshes = self
            .meshes
            .into_iter()
            .map(|mesh| mesh.finish(|name| names.find(name), &mut self.warnings))
            .filter(|mesh| !mesh.faces.is_empty())
            .collect();
        Document { meshes, materials: self.materials, warnings: self.warnings }
    }
}

/// Looks materials up by name: byte for byte, else without case and trailing
/// blanks.
struct MaterialNames {
    exact: HashMap<String, usize>,
    loose: HashMap<String, usize>,
}

impl MaterialNames {
    fn new(materials: &[Material]) -> Self {
        let mut names = Self { exact: HashMap::new(), loose: HashMap::new() };
        for (index, material) in materials.iter().enumerate() {
            names.exact.entry(material.name.clone()).or_insert(index);
            names.loose.entry(loose(&material.name)).or_insert(index);
        }
        names
    }

    fn find(&self, name: &str) -> Option<usize> {
        self.exact.get(name).or_else(|| self.loose.get(&loose(name))).copied()
    }
}

fn loose(name: &str) -> String {
    name.trim_end().to_lowercase()
}

#[cfg(test)]
mod tests;
