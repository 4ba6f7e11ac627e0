//! Objects: shapes with their materials.

use super::files::SceneFile;
use super::imported_object::{ImportedObject, ObjectMaterial};
use super::material::Materials;
use super::mesh::MeshImporter;
use super::model::ModelFiles;
use super::model_part::ModelSide;
use super::place::Place;
use super::shape;
use crate::locate::{Path, Step};
use crate::report::Problems;
use crate::ron_scene::{self, Shape};
use traylib_geometry::Sides;
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

/// An object with its place, from which the scene is built. A box is six of these, a mesh one for
/// each material of its file.
pub(super) struct Part {
    pub(super) place: Place,
    pub(super) item: ImportedObject,
}

/// All parts of all objects that make sense.
pub(super) fn collect(
    files: &[SceneFile],
    materials: &Materials,
    models: &mut ModelFiles,
    problems: &mut Problems,
) -> Vec<Part> {
    let mut parts = Vec::new();
    for file in files {
        for (index, object) in file.document.objects.iter().enumerate() {
            let place = file.place(Path::of("objects").then(Step::Index(index)));
            let mut importer = Importer { file, object, place, problems };
            importer.add(materials, models, &mut parts);
        }
    }
    parts
}

/// Brings in one object.
struct Importer<'a> {
    file: &'a SceneFile,
    object: &'a ron_scene::Object,
    place: Place,
    problems: &'a mut Problems,
}

impl Importer<'_> {
    fn add(&mut self, materials: &Materials, models: &mut ModelFiles, parts: &mut Vec<Part>) {
        let emission = self.object.emission.map(Rgb::from);
        let to_check = emission.unwrap_or(Rgb::BLACK);
        self.place.field("emission").check_light("emission", to_check, self.problems);
        let named = self.object.material.as_ref().map(|name| {
            let place = self.place.field("material");
            materials.find(name, &place, self.problems)
        });
        let items = if let Shape::Mesh(mesh) = &self.object.shape {
            let (file, object, place) = (self.file, self.object, &self.place);
            MeshImporter { file, object, mesh, place, materials, problems: self.problems }
                .items(named.flatten(), models)
        } else {
            self.primitives(&self.object.shape, named.flatten(), to_check)
        };
        let place = &self.place;
        parts.extend(items.into_iter().map(|item| Part { place: place.clone(), item }));
    }

    fn primitives(
        &mut self,
        shape: &Shape,
        named: Option<usize>,
        emission: Rgb,
    ) -> Vec<ImportedObject> {
        let found = shape::primitives(shape, &self.place.field("shape"), self.problems);
        if self.object.material.is_none() {
            let problem = self.place.problem("the object has no material");
            self.problems.push(problem.with_help("only a Mesh may do without `material`"));
        }
        // A material that was not found has been reported already.
        let Some(material) = named.map(ObjectMaterial::Named) else { return Vec::new() };
        let sides = self.object.sides.map_or(Sides::Both, Sides::from);
        let shapes = found.into_iter().map(ObjectShape::Primitive);
        shapes
            .map(|shape| ImportedObject {
                shape,
                sides,
                material,
                emission,
                side: ModelSide::Whole,
            })
            .collect()
    }
}
