//! Objects whose shape comes from a file.

use super::counter::Counter;
use super::files::SceneFile;
use super::frame;
use super::material::Materials;
use super::model::{Half, Look, ModelFile, ModelFiles, NumberedFile, is_model};
use super::place::Place;
use super::placement::Placement;
use super::thing::{Thing, ThingMaterial};
use crate::report::{Problem, Problems};
use crate::ron_scene::locate::Step;
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
    /// Of the object.
    pub(super) place: &'a Place,
    pub(super) materials: &'a Materials,
    pub(super) problems: &'a mut Problems,
}

impl MeshImporter<'_> {
    /// The file's things as the object wants them: `named` is the number of its
    /// material, if it has one.
    pub(super) fn things(&mut self, named: Option<usize>, models: &mut ModelFiles) -> Vec<Thing> {
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
        let replaced = self.replaced(&model.file.looks);
        let mut counter = Counter::default();
        let parts = shape.note(model.file.parts(&placement, &mut counter), self.problems);
        self.note_unused(&model.file, &mut counter);
        models.warn(&location, counter);
        let glow = glow.unwrap_or(if model.file.is_physical() { 1.0 } else { 0.0 });
        let mut things = Vec::new();
        for part in parts.unwrap_or_default() {
            let (half, number, look) = (part.half, part.look, &model.file.looks[part.look]);
            if half == Half::Back && self.object.sides == Some(ron_scene::Sides::Front) {
                continue;
            }
            let mut thing = Thing::of_model(look, part, model.first, glow);
            if self.object.sides == Some(ron_scene::Sides::Front) {
                // Its other half is left out.
                thing.half = Half::Whole;
            }
            let named = named.or_else(|| replaced.get(&number).copied());
            self.change(&mut thing, half, named);
            things.push(thing);
        }
        models.add_lights(placed_lights(&model, &placement, lights, &things));
        things
    }

    fn not_usable(&self, error: String, location: &Location) -> Problem {
        let is_model = is_model(Path::new(&self.mesh.file));
        let what = || (!is_model).then(|| "a Mesh is a 3DS or an MGF file".to_string());
        let help = location.advice(&self.mesh.file).or_else(what);
        self.place.field("shape").field("file").problem(error).with_help_if_any(help)
    }

    /// What could shine if the object wanted it.
    fn note_unused(&self, file: &ModelFile, counter: &mut Counter) {
        let (lights, glows) = file.unused_light();
        if lights > 0 && self.mesh.lights == 0.0 {
            counter.add_many("light not taken (`lights: 1` takes it)", lights as u32);
        }
        if glows && self.mesh.glow.is_none() {
            counter.add("self-illumination not taken (`glow: 1` takes it)");
        }
    }

    /// What the object says goes before what the file says.
    fn change(&self, thing: &mut Thing, half: Half, named: Option<usize>) {
        if let Some(number) = named {
            thing.material = ThingMaterial::Named(number);
        }
        if let Some(emission) = self.object.emission {
            thing.emission = Rgb::from(emission);
        }
        if half == Half::Whole {
            let without = named.map(|_| Sides::Both);
            let sides = self.object.sides.map(Sides::from).or(without);
            thing.sides = sides.unwrap_or(thing.sides);
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
    fn replaced(&mut self, looks: &[Look]) -> BTreeMap<usize, usize> {
        let mut replaced = BTreeMap::new();
        let place = self.place.field("shape").field("materials");
        for (index, (of_file, of_scene)) in self.mesh.materials.0.iter().enumerate() {
            let value = place.then(Step::Value(index));
            let number = self.materials.find(of_scene, &value, self.problems);
            let mut found = false;
            for (look, _) in looks.iter().enumerate().filter(|(_, look)| look.name == *of_file) {
                found = true;
                replaced.extend(number.map(|number| (look, number)));
            }
            if !found {
                let key = place.then(Step::Key(index));
                self.problems.push_with(|| no_such_material(&key, of_file, looks));
            }
        }
        replaced
    }
}

fn no_such_material(place: &Place, name: &str, looks: &[Look]) -> Problem {
    let names = || looks.iter().map(|look| look.name.as_str()).filter(|name| !name.is_empty());
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
    things: &[Thing],
) -> Vec<PointLight> {
    let dimmed = |light: PointLight| PointLight { intensity: light.intensity * factor, ..light };
    let of = |file: &ModelFile| file.lights(placement, &frame::bounds(things));
    if factor > 0.0 { of(&model.file).into_iter().map(dimmed).collect() } else { Vec::new() }
}
