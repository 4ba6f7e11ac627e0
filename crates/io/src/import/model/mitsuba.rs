//! Shapes, materials, lights and the camera of Mitsuba's scene files.
//!
//! Mitsuba's surfaces scatter light on the side that their normals point to, and are black behind
//! unless a `twosided` says otherwise. Ours scatter on both sides, or are not there from behind.
//! So a surface that is not `twosided` becomes two: its front, and a black back.
//!
//! Texture coordinates stay Mitsuba's, whose v goes down from the top of a picture; the placement
//! of each picture turns it.

mod content;
mod fields;
mod form;
mod index;
mod light;
mod mask;
mod mesh;
mod metal;
mod paint;
mod panel;
mod sensor;
mod shape;
mod sky;
mod surface;
mod texture;

pub(super) use content::Content;

use super::beside::{Beside, is_from_root};
use super::pictures::Pictures;
use super::source::ModelSource;
use super::{Format, ModelFile};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::textures::Textures;
use crate::load_options::LoadOptions;
use crate::mitsuba::{self, Class, Document, Included};
use crate::polygon_limits::PolygonLimits;
use crate::source::{Location, why};
use crate::{Error, Warning};
use mesh::MeshKey;
use shape::Faces;
use std::collections::HashMap;
use std::rc::Rc;
use surface::Surface;
use texture::Checkerboards;

/// Reads a file with all that it includes, and returns with it what was repaired in its pictures.
pub(super) fn read(
    location: &Location,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let source = ModelSource::new(location);
    let beside = Beside::of(location, options);
    let limits = options.limits.mitsuba();
    let mut load = |name: &str| included(&beside, name);
    let document = mitsuba::decode(&source.name, &source.bytes()?, limits, &mut load)?;
    counter.add_counts(&document.warnings);
    let mut textures = Textures::new(options.limits);
    let mut importer = Importer {
        document: &document,
        beside: &beside,
        pictures: Pictures { textures: &mut textures, counter },
        polygons: options.limits.polygons(),
        triangles_left: limits.triangles,
        limits,
        surfaces: HashMap::new(),
        faces: HashMap::new(),
        meshes: HashMap::new(),
        checkerboards: Checkerboards::default(),
        materials: Vec::new(),
        content: Content::default(),
    };
    importer.all()?;
    let Importer { materials, content, .. } = importer;
    if content.is_empty() {
        return Err(source.nothing_to_see());
    }
    let content = super::Content::Mitsuba(content);
    let file = ModelFile { materials, format: Format::Mitsuba, content };
    Ok((file, textures.into_warnings()))
}

/// Reads a file that the scene includes; names that lead elsewhere are none.
fn included(beside: &Beside, name: &str) -> Result<Included, String> {
    let location = in_folder(beside, name)?;
    let bytes = location.read().map_err(|cause| why(&cause))?.into_owned();
    Ok(Included { name: location.to_string(), bytes })
}

/// Finds a file of exactly this name; of one that begins at the root of all files, as Mitsuba's own
/// writer has them, also the file beside the scene: scenes move to other machines.
fn in_folder(beside: &Beside, name: &str) -> Result<Location, String> {
    let name = name.replace('\\', "/");
    let last = name.rsplit('/').next().filter(|last| is_from_root(&name) && !last.is_empty());
    let found = beside.exactly(&name).or_else(|| beside.exactly(last?));
    found.ok_or_else(|| "there is no such file in the folder of the scene".to_string())
}

/// Makes what is in a document ours.
struct Importer<'a> {
    document: &'a Document,
    beside: &'a Beside,
    pictures: Pictures<'a>,
    polygons: PolygonLimits,
    limits: mitsuba::Limits,
    triangles_left: u64,
    /// The ways to scatter light so far, by object.
    surfaces: HashMap<usize, Rc<Surface>>,
    /// The materials of both sides so far, by object and the bits of what they emit.
    faces: HashMap<(Option<usize>, [u32; 3]), Faces>,
    meshes: HashMap<MeshKey, mesh::Loaded>,
    checkerboards: Checkerboards,
    materials: Vec<ImportedMaterial>,
    content: Content,
}

impl Importer<'_> {
    fn all(&mut self) -> Result<(), Error> {
        for &root in &self.document.roots {
            match self.document.objects[root].class {
                Class::Shape => self.shape(root)?,
                Class::Emitter => self.light(root),
                Class::Sensor => self.sensor(root),
                Class::Medium => self.skipped(root),
                // Materials and pictures count where they are used; programs choose the rest.
                Class::Bsdf
                | Class::Texture
                | Class::Film
                | Class::Sampler
                | Class::Integrator
                | Class::Filter => {}
            }
        }
        Ok(())
    }

    /// Counts what there is nothing for here.
    fn skipped(&mut self, object: usize) {
        let object = &self.document.objects[object];
        let (class, kind) = (object.class.name(), crate::suggest::shown(&object.kind));
        self.pictures.counter.add(format!("{class} `{kind}` skipped"));
    }
}

#[cfg(test)]
mod tests;
