//! From chunks to a document.

use super::chunk::Reader;
use super::colour::colour;
use super::keyframer::{Keyframer, hierarchy};
use super::limits::{Limits, Remaining};
use super::names::MaterialNames;
use super::raw_mesh::RawMesh;
use super::{Camera, Document, Light, ObjectFlags, Warnings, camera, light, material};

const MESH_DATA: u16 = 0x3d3d;
const VERSION: u16 = 0x0002;
const MESH_VERSION: u16 = 0x3d3e;
const MASTER_SCALE: u16 = 0x0100;
const AMBIENT: u16 = 0x2100;
const MATERIAL: u16 = 0xafff;
const OBJECT: u16 = 0x4000;
const TRIANGLES: u16 = 0x4100;
const LIGHT: u16 = 0x4600;
const CAMERA: u16 = 0x4700;
const KEYFRAMER: u16 = 0xb000;

/// The data that has been read so far. Meshes join the document last: they may use materials before
/// these are defined.
pub(super) struct Decoder {
    document: Document,
    meshes: Vec<RawMesh>,
    warnings: Warnings,
    remaining: Remaining,
}

impl Decoder {
    pub(super) fn new(warnings: Warnings, limits: Limits) -> Self {
        let (document, meshes) = (Document::default(), Vec::new());
        Self { document, meshes, warnings, remaining: Remaining::new(limits) }
    }

    /// The root or the mesh section: some writers put materials and objects
    /// directly under the root.
    pub(super) fn section(&mut self, mut reader: Reader<'_>) {
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

    fn item(&mut self, id: u16, mut body: Reader<'_>) {
        let Self { document, warnings, remaining, .. } = self;
        match id {
            VERSION => document.version = body.u32(),
            MESH_VERSION => document.mesh_version = body.u32(),
            MASTER_SCALE => document.master_scale = body.number(warnings),
            AMBIENT => document.ambient = colour(body, warnings),
            MATERIAL if remaining.take(warnings) => {
                document.materials.push(material::decode(body, warnings, remaining));
            }
            OBJECT => self.object(body),
            KEYFRAMER => {
                let keyframer = document.keyframer.get_or_insert_with(Keyframer::default);
                keyframer.read(body, warnings, remaining);
            }
            _ => {}
        }
    }

    fn object(&mut self, mut reader: Reader<'_>) {
        let name = reader.string();
        let flags = object_flags(reader);
        while let Some((id, body)) = reader.next_chunk(&mut self.warnings) {
            if matches!(id, TRIANGLES | LIGHT | CAMERA) && self.remaining.take(&mut self.warnings) {
                self.body(id, name.clone(), flags, body);
            }
        }
    }

    fn body(&mut self, id: u16, name: String, flags: ObjectFlags, body: Reader<'_>) {
        let Self { document, meshes, warnings, .. } = self;
        match id {
            LIGHT => {
                let light = light::decode(name, body, warnings);
                document.lights.extend(light.map(|light| Light { flags, ..light }));
            }
            CAMERA => {
                let camera = camera::decode(name, body, warnings);
                document.cameras.extend(camera.map(|camera| Camera { flags, ..camera }));
            }
            _ => meshes.push(RawMesh::decode(name, flags, body, warnings)),
        }
    }

    pub(super) fn finish(mut self) -> Document {
        let names = MaterialNames::new(&self.document.materials);
        let finished = |mesh: RawMesh| mesh.finish(|name| names.find(name), &mut self.warnings);
        self.document.meshes = self.meshes.into_iter().map(finished).collect();
        if let Some(keyframer) = &mut self.document.keyframer {
            hierarchy::link(&mut keyframer.nodes, &mut self.warnings);
        }
        Document { warnings: self.warnings, ..self.document }
    }
}

/// The marks of an object, which stand before or after what they mark. Damage is
/// warned about when the chunks are read for what is in them.
fn object_flags(mut reader: Reader<'_>) -> ObjectFlags {
    let mut flags = ObjectFlags::default();
    let mut seen = Warnings::default();
    while let Some((id, _)) = reader.next_chunk(&mut seen) {
        flags.read(id);
    }
    flags
}
