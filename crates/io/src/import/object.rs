//! Objects: shapes with their materials.

use super::files::SceneFile;
use super::material::Materials;
use super::mesh::MeshFiles;
use super::place::Place;
use super::placement::Placement;
use super::shape;
use crate::report::Problem;
use crate::ron_scene::locate::{Path, Step};
use crate::ron_scene::{self, Shape};
use traylib_geometry::Sides;
use traylib_materials::SurfaceModel;
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

/// What the scene is built from. A box is six of these, a mesh one for each
/// material of its file.
pub(super) struct Part {
    pub(super) place: Place,
    pub(super) shape: ObjectShape,
    pub(super) sides: Sides,
    pub(super) material: PartMaterial,
    pub(super) emission: Rgb,
}

/// What a part is made of.
#[derive(Clone, Copy)]
pub(super) enum PartMaterial {
    /// The number of a named material.
    Named(usize),
    /// A material of the mesh's own file.
    Own(SurfaceModel),
}

/// All parts of all objects that make sense.
pub(super) fn collect(
    files: &[SceneFile],
    materials: &Materials,
    meshes: &mut MeshFiles,
    problems: &mut Vec<Problem>,
) -> Vec<Part> {
    let mut parts = Vec::new();
    for file in files {
        for (index, object) in file.document.objects.iter().enumerate() {
            let place = file.place(Path::of("objects").then(Step::Index(index)));
            let mut importer = Importer { file, object, place, problems };
            importer.add(materials, meshes, &mut parts);
        }
    }
    parts
}

/// Brings in one object.
struct Importer<'a> {
    file: &'a SceneFile,
    object: &'a ron_scene::Object,
    place: Place,
    problems: &'a mut Vec<Problem>,
}

impl Importer<'_> {
    fn add(&mut self, materials: &Materials, meshes: &mut MeshFiles, parts: &mut Vec<Part>) {
        let emission = self.object.emission.map_or(Rgb::BLACK, Rgb::from);
        self.place.field("emission").check_light("emission", emission, self.problems);
        let named = self.object.material.as_ref().map(|name| {
            let place = self.place.field("material");
            materials.find(name, &place, self.problems).map(PartMaterial::Named)
        });
        let shapes = match &self.object.shape {
            Shape::Mesh(mesh) => self.mesh(mesh, meshes),
            shape => self.primitives(shape),
        };
        for (shape, own) in shapes {
            // A material that was not found has been reported already.
            let material = match named {
                Some(found) => found,
                None => own.map(|(model, _)| PartMaterial::Own(model)),
            };
            let sides = self.sides(own.map(|(_, sides)| sides));
            let place = self.place.clone();
            parts.extend(material.map(|material| Part { place, shape, sides, material, emission }));
        }
    }

    /// What the object says; else what the file of the mesh says of a material
    /// of its own; else both.
    fn sides(&self, own: Option<Sides>) -> Sides {
        match self.object.sides {
            Some(ron_scene::Sides::Both) => Sides::Both,
            Some(ron_scene::Sides::Front) => Sides::Front,
            None if self.object.material.is_some() => Sides::Both,
            None => own.unwrap_or(Sides::Both),
        }
    }

    fn primitives(&mut self, shape: &Shape) -> Vec<(ObjectShape, Option<(SurfaceModel, Sides)>)> {
        if self.object.material.is_none() {
            let problem = self.place.problem("the object has no material");
            self.problems.push(problem.with_help("only a Mesh may do without `material`"));
        }
        let primitives = shape::primitives(shape);
        let found = self.place.field("shape").note(primitives, self.problems).unwrap_or_default();
        found.into_iter().map(|primitive| (ObjectShape::Primitive(primitive), None)).collect()
    }

    fn mesh(
        &mut self,
        mesh: &ron_scene::Mesh,
        meshes: &mut MeshFiles,
    ) -> Vec<(ObjectShape, Option<(SurfaceModel, Sides)>)> {
        let shape = self.place.field("shape");
        let placement = Placement::new(mesh)
            .map_err(|(field, message)| self.problems.push(shape.field(field).problem(message)));
        let location = self.file.location.beside(&mesh.file);
        let file = shape.field("file").note(meshes.load(&location), self.problems);
        let (Ok(placement), Some(file)) = (placement, file) else { return Vec::new() };
        let parts = shape.note(file.parts(&placement), self.problems).unwrap_or_default();
        let part = |(mesh, model, sides)| (ObjectShape::Mesh(mesh), Some((model, sides)));
        parts.into_iter().map(part).collect()
    }
}
