//! Files that bring shapes with materials of their own: 3DS, MGF, OBJ, PLY, glTF and Mitsuba's.

mod appearance;
mod arrays;
mod beside;
pub(super) mod counts;
mod folder;
mod format;
mod gltf;
mod meshes;
mod mgf;
mod mitsuba;
mod obj;
mod pictures;
mod plain;
mod ply;
mod source;
mod three_ds;

pub(super) use format::Format;

use super::counter::Counter;
use super::imported_material::ImportedMaterial;
use super::model_camera::ModelCamera;
use super::model_part::ModelPart;
use super::placement::Placement;
use super::sky_light::SkyLight;
use crate::load_options::LoadOptions;
use crate::source::{Location, why};
use crate::{Error, Warning};
use std::collections::HashMap;
use std::path::Path;
use std::rc::Rc;
use traylib_geometry::{self as geometry, Aabb};
use traylib_materials::Material;
use traylib_scene::PointLight;

/// A file with what does not depend on where it goes.
pub(super) struct ModelFile {
    pub(super) materials: Vec<ImportedMaterial>,
    pub(super) format: Format,
    content: Content,
}

enum Content {
    Mgf(Vec<crate::mgf::Surface>),
    ThreeDs(three_ds::Content),
    Meshes(meshes::Content),
    Mitsuba(mitsuba::Content),
}

impl ModelFile {
    /// Reads a file of the format that its name says, else 3DS; with what there is to warn
    /// of. Of the options root and limits count.
    ///
    /// # Errors
    /// It cannot be read or makes no sense.
    pub(super) fn read(
        location: &Location,
        options: LoadOptions<'_>,
    ) -> Result<(Self, Vec<Warning>), Error> {
        let mut counter = Counter::default();
        // Of those that are compiled in none is an MGF file, which names others by paths.
        let path = match location {
            Location::Disk(path) => path.as_path(),
            Location::BuiltIn(name) => Path::new(name),
        };
        let (file, mut warnings) = match Format::of(path).unwrap_or(Format::ThreeDs) {
            Format::Mgf => mgf::read(path, options, &mut counter)?,
            Format::ThreeDs => three_ds::read(location, options.limits, &mut counter)?,
            Format::Gltf => gltf::read(location, options, &mut counter)?,
            Format::Obj => obj::read(location, options, &mut counter)?,
            Format::Ply => ply::read(location, options, &mut counter)?,
            Format::Mitsuba => mitsuba::read(location, options, &mut counter)?,
        };
        warnings.extend(counter.into_warnings(&location.to_string()));
        Ok((file, warnings))
    }

    fn of_meshes(
        format: Format,
        materials: Vec<ImportedMaterial>,
        content: meshes::Content,
    ) -> Self {
        Self { materials, format, content: Content::Meshes(content) }
    }

    /// The file's shapes where they go.
    pub(super) fn parts(
        &self,
        placement: &Placement,
        counter: &mut Counter,
    ) -> Result<Vec<ModelPart>, geometry::Error> {
        match &self.content {
            Content::Mgf(surfaces) => mgf::parts(surfaces, &self.materials, placement, counter),
            Content::ThreeDs(content) => content.parts(placement),
            Content::Meshes(content) => content.parts(&self.materials, placement),
            Content::Mitsuba(content) => Ok(content.parts(placement, counter)),
        }
    }

    /// Lets go of its shapes, once they are where they go and its lights are known.
    pub(super) fn forget_shapes(&mut self) {
        match &mut self.content {
            Content::Mgf(surfaces) => *surfaces = Vec::new(),
            Content::ThreeDs(content) => content.forget_shapes(),
            Content::Meshes(content) => content.forget_shapes(),
            Content::Mitsuba(content) => content.forget_shapes(),
        }
    }

    /// Its lights, as bright as 3D Studio shows them in the middle of what is `around`.
    pub(super) fn lights(&self, placement: &Placement, around: &Aabb) -> Vec<PointLight> {
        match &self.content {
            Content::Mgf(_) => Vec::new(),
            Content::ThreeDs(content) => content.lights(placement, around),
            Content::Meshes(content) => content.lights(placement),
            Content::Mitsuba(content) => content.lights(placement),
        }
    }

    /// Its light from all around.
    pub(super) fn sky(&self) -> Option<&SkyLight> {
        match &self.content {
            Content::Mgf(_) | Content::ThreeDs(_) | Content::Meshes(_) => None,
            Content::Mitsuba(content) => content.sky.as_ref(),
        }
    }

    /// Returns the number of its lights, and whether a material shines by itself without a
    /// unit.
    pub(super) fn unused_light(&self) -> (usize, bool) {
        let glows = self.materials.iter().any(|material| !material.emission.is_black());
        let lights = match &self.content {
            Content::Mgf(_) => 0,
            Content::ThreeDs(content) => content.light_count(),
            Content::Meshes(content) => content.lights.len(),
            Content::Mitsuba(content) => content.lights.len(),
        };
        (lights, glows && self.format.usual_glow() == 0.0)
    }

    /// Its first camera.
    pub(super) fn camera(&self) -> Option<ModelCamera> {
        match &self.content {
            Content::Mgf(_) => None,
            Content::ThreeDs(content) => content.camera(),
            Content::Meshes(content) => content.camera,
            Content::Mitsuba(content) => content.camera,
        }
    }

    /// Samples per pixel, if it says.
    pub(super) fn samples(&self) -> Option<u32> {
        match &self.content {
            Content::Mgf(_) | Content::ThreeDs(_) | Content::Meshes(_) => None,
            Content::Mitsuba(content) => content.samples,
        }
    }
}

/// The files read so far: each is read, and warned about, once.
pub(super) struct ModelFiles<'a> {
    /// The folder that included files may come from, if the caller says, and the limits of
    /// readers.
    options: LoadOptions<'a>,
    files: HashMap<Location, Result<Rc<NumberedFile>, String>>,
    materials: Vec<Material>,
    /// The names of the materials.
    names: Vec<String>,
    lights: Vec<PointLight>,
    warnings: Vec<Warning>,
}

/// A file whose materials have numbers.
pub(super) struct NumberedFile {
    pub(super) file: ModelFile,
    /// The number of its first material.
    pub(super) first: usize,
}

impl<'a> ModelFiles<'a> {
    pub(super) fn new(options: LoadOptions<'a>) -> Self {
        Self {
            options,
            files: HashMap::new(),
            materials: Vec::new(),
            names: Vec::new(),
            lights: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// A file, which may include others from its own folder and that of the scene
    /// file; why it cannot be used, else.
    pub(super) fn load(
        &mut self,
        location: &Location,
        scene: &Location,
    ) -> Result<Rc<NumberedFile>, String> {
        if let Some(known) = self.files.get(location) {
            return known.clone();
        }
        let file = self.read(location, scene);
        self.files.insert(location.clone(), file.clone());
        file
    }

    #[expect(clippy::wildcard_enum_match_arm, reason = "other errors say themselves what they are")]
    fn read(&mut self, location: &Location, scene: &Location) -> Result<Rc<NumberedFile>, String> {
        let root = self.options.root.or_else(|| scene.folder());
        let options = LoadOptions { root, ..self.options };
        let (file, warnings) = ModelFile::read(location, options).map_err(|error| {
            let cause = match error {
                Error::Read { cause, .. } => why(&cause),
                Error::Format { file, cause } if file == location.to_string() => cause.to_string(),
                Error::Mgf(crate::mgf::Error::File { fault, .. }) => fault.to_string(),
                Error::NothingToSee(_) => "it has no face that can be drawn".to_string(),
                other => other.to_string(),
            };
            format!("{location} cannot be used: {cause}")
        })?;
        self.warnings.extend(warnings);
        let first = self.materials.len();
        self.materials.extend(file.materials.iter().map(|material| material.surface.clone()));
        self.names.extend(file.materials.iter().map(|material| material.name.clone()));
        Ok(Rc::new(NumberedFile { file, first }))
    }

    /// Takes note of what was met while shapes were made.
    pub(super) fn warn(&mut self, location: &Location, counter: Counter) {
        self.warnings.extend(counter.into_warnings(&location.to_string()));
    }

    /// Adds lights that a scene wants from a file.
    pub(super) fn add_lights(&mut self, lights: impl IntoIterator<Item = PointLight>) {
        self.lights.extend(lights);
    }

    /// Lets go of the files, once all of their shapes are where they go.
    pub(super) fn forget_files(&mut self) {
        self.files = HashMap::new();
    }

    /// The lights wanted so far.
    pub(super) fn take_lights(&mut self) -> impl Iterator<Item = PointLight> {
        self.lights.drain(..)
    }

    /// The materials of all files, by number.
    pub(super) fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// Returns the name that a file has for its material of this number.
    pub(super) fn name(&self, number: usize) -> &str {
        &self.names[number]
    }

    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.warnings
    }
}

#[cfg(test)]
mod tests;
