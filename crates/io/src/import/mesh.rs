//! Objects whose shape comes from a file.

use super::counter::Counter;
use super::files::SceneFile;
use super::frame;
use super::imported_material::ImportedMaterial;
use super::imported_object::{ImportedObject, ObjectMaterial};
use super::material::Materials;
use super::model::{Format, ModelFile, ModelFiles, NumberedFile};
use super::model_part::ModelSide;
use super::place::Place;
use super::placement::Placement;
use crate::locate::Step;
use crate::report::{Problem, Problems};
use crate::ron_scene::{self, Mesh, Object};
use crate::source::Location;
use crate::suggest::{nearest, quoted_list, shown};
use std::collections::BTreeMap;
use std::path::Path;
use traylib_geometry::Sides;
use traylib_math::Rgb;
use traylib_scene::PointLight;

/// Brings in one object of this kind.
pub(super) struct MeshImporter<'a> {
    pub(super) file: &'a SceneFile,
    pub(super) object: &'a Object,
    pub(super) mesh: &'a Mesh,
    /// The place of the object in the file.
    pub(super) place: &'a Place,
    pub(super) materials: &'a Materials,
    pub(super) problems: &'a mut Problems,
}

impl MeshImporter<'_> {
    /// The objects of the file as the scene wants them: `named` is the number of its
    /// material, if it has one.
    pub(super) fn items(
        &mut self,
        named: Option<usize>,
        models: &mut ModelFiles,
    ) -> Vec<ImportedObject> {
        let shape = self.place.field("shape");
        let Mesh { scale, rotate, translate, .. } = *self.mesh;
        let placement = Placement::new(scale, rotate, translate)
            .map_err(|(field, message)| self.problems.push(shape.field(field).problem(message)));
        let glow = self.factor("glow", self.mesh.glow);
        let lights = self.factor("lights", Some(self.mesh.lights)).unwrap_or(0.0);
        let location = self.file.location.beside(&self.mesh.file);
        let model = models.load(&location, &self.file.location);
        let model =
            model.map_err(|error| self.problems.push(self.not_usable(error, &location))).ok();
        let (Ok(placement), Some(model)) = (placement, model) else { return Vec::new() };
        let replaced = self.replaced(&model.file.materials);
        let mut counter = Counter::default();
        let parts = shape.note(model.file.parts(&placement, &mut counter), self.problems);
        self.note_unused(&model.file, &mut counter);
        models.warn(&location, counter);
        let glow = glow.unwrap_or(model.file.format.usual_glow());
        let mut items = Vec::new();
        for part in parts.unwrap_or_default() {
            let (side, number, material) =
                (part.side, part.material, &model.file.materials[part.material]);
            if side == ModelSide::Back && self.object.sides == Some(ron_scene::Sides::Front) {
                continue;
            }
            let mut item = ImportedObject::of_model(material, part, model.first, glow);
            if self.object.sides == Some(ron_scene::Sides::Front) {
                // Its other side is left out.
                item.side = ModelSide::Whole;
            }
            let named = named.or_else(|| replaced.get(&number).copied());
            self.change(&mut item, side, named);
            items.push(item);
        }
        models.add_lights(placed_lights(&model, &placement, lights, &items));
        items
    }

    fn not_usable(&self, error: String, location: &Location) -> Problem {
        let is_model = Format::of(Path::new(&self.mesh.file)).is_some();
        let what = || {
            (!is_model).then(|| "a Mesh is an OBJ, PLY, glTF, 3DS, MGF or Mitsuba file".to_string())
        };
        let help = location.advice(&self.mesh.file).or_else(what);
        self.place.field("shape").field("file").problem(error).with_help_if_any(help)
    }

    /// Counts the lights that could shine if the object wanted it.
    fn note_unused(&self, file: &ModelFile, counter: &mut Counter) {
        let (lights, glows) = file.unused_light();
        if file.sky().is_some() {
            counter.add("sky not taken: `sky` of the scene file is");
        }
        if lights > 0 && self.mesh.lights == 0.0 {
            counter.add_many("light not taken (`lights: 1` takes it)", lights as u32);
        }
        if glows && self.mesh.glow.is_none() {
            counter.add("self-illumination not taken (`glow: 1` takes it)");
        }
    }

    /// Overrides what the file says by what the object says.
    fn change(&self, item: &mut ImportedObject, side: ModelSide, named: Option<usize>) {
        if let Some(number) = named {
            item.material = ObjectMaterial::Named(number);
        }
        if let Some(emission) = self.object.emission {
            item.emission = Rgb::from(emission);
        }
        if side == ModelSide::Whole {
            let without = named.map(|_| Sides::Both);
            let sides = self.object.sides.map(Sides::from).or(without);
            item.sides = sides.unwrap_or(item.sides);
        }
    }

    fn factor(&mut self, field: &'static str, factor: Option<f32>) -> Option<f32> {
        if factor.is_some_and(|factor| !(factor >= 0.0 && factor.is_finite())) {
            let place = self.place.field("shape").field(field);
            self.problems.push(place.problem("the factor must be finite and not negative"));
        }
        factor
    }

    /// The numbers of the scene's materials for those of the file.
    fn replaced(&mut self, materials: &[ImportedMaterial]) -> BTreeMap<usize, usize> {
        let mut replaced = BTreeMap::new();
        let place = self.place.field("shape").field("materials");
        for (index, (of_file, of_scene)) in self.mesh.materials.0.iter().enumerate() {
            let value = place.then(Step::Value(index));
            let number = self.materials.find(of_scene, &value, self.problems);
            let mut found = false;
            for (material, _) in
                materials.iter().enumerate().filter(|(_, material)| material.name == *of_file)
            {
                found = true;
                replaced.extend(number.map(|number| (material, number)));
            }
            if !found {
                let key = place.then(Step::Key(index));
                self.problems.push_with(|| no_such_material(&key, of_file, materials));
            }
        }
        replaced
    }
}

fn no_such_material(place: &Place, name: &str, materials: &[ImportedMaterial]) -> Problem {
    let names =
        || materials.iter().map(|material| material.name.as_str()).filter(|name| !name.is_empty());
    let label = nearest(name, names()).map(|near| format!("did you mean `{near}`?"));
    let title = format!("the file has no material named `{}`", shown(name));
    let problem = place.labelled(title, label.unwrap_or_default());
    problem.with_help(format!("its materials are {}", quoted_list(names())))
}

/// The file's lights, if any are wanted.
fn placed_lights(
    model: &NumberedFile,
    placement: &Placement,
    factor: f32,
    items: &[ImportedObject],
) -> Vec<PointLight> {
    let dimmed = |light: PointLight| PointLight { intensity: light.intensity * factor, ..light };
    let of = |file: &ModelFile| file.lights(placement, &frame::bounds(items));
    if factor > 0.0 { of(&model.file).into_iter().map(dimmed).collect() } else { Vec::new() }
}
