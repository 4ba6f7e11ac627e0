//! Materials of scene files, by name.

mod make;

use super::files::SceneFile;
use super::place::Place;
use super::textures::Textures;
use crate::locate::{Path, Step};
use crate::report::{Problem, Problems};
use crate::ron_scene::Material;
use crate::source::Location;
use crate::suggest::{nearest, quoted_list, shown};
use crate::{ReadLimits, Warning};
use make::Maker;
use std::collections::HashMap;

/// The named materials of all files.
#[derive(Default)]
pub(super) struct Materials {
    models: Vec<traylib_materials::Material>,
    /// The names of the models.
    model_names: Vec<String>,
    /// `None` is a material that has an error of its own.
    by_name: HashMap<String, Option<usize>>,
    /// In file order, for messages.
    names: Vec<String>,
    textures: Textures,
}

impl Materials {
    pub(super) fn collect(
        files: &[SceneFile],
        limits: ReadLimits,
        problems: &mut Problems,
    ) -> Self {
        let mut materials = Self { textures: Textures::new(limits), ..Self::default() };
        for file in files {
            for (index, (name, material)) in file.document.materials.0.iter().enumerate() {
                let path = Path::of("materials");
                let key = file.place(path.then(Step::Key(index)));
                let value = file.place(path.then(Step::Value(index)));
                materials.add(name, material, &file.location, [&key, &value], problems);
            }
        }
        materials
    }

    fn add(
        &mut self,
        name: &str,
        material: &Material,
        location: &Location,
        [key, value]: [&Place; 2],
        problems: &mut Problems,
    ) {
        if self.by_name.contains_key(name) {
            let title = format!("two materials are named `{}`", shown(name));
            problems.push(key.labelled(title, "the second"));
            return;
        }
        let mut maker = Maker { location, textures: &mut self.textures, problems };
        let index = maker.material(value, material).map(|model| {
            self.models.push(model);
            self.model_names.push(name.to_string());
            self.models.len() - 1
        });
        self.by_name.insert(name.to_string(), index);
        self.names.push(name.to_string());
    }

    /// The models, by the numbers that [`find`](Self::find) gives.
    pub(super) fn models(&self) -> &[traylib_materials::Material] {
        &self.models
    }

    /// Returns the name of the model of this number.
    pub(super) fn name(&self, number: usize) -> &str {
        &self.model_names[number]
    }

    /// Their pictures, and what else reads some within the same limits.
    pub(super) fn textures(&mut self) -> &mut Textures {
        &mut self.textures
    }

    /// Returns warnings of what was repaired in their pictures.
    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.textures.into_warnings()
    }

    /// The number of a material's model.
    pub(super) fn find(&self, name: &str, place: &Place, problems: &mut Problems) -> Option<usize> {
        if let Some(found) = self.by_name.get(name) {
            return *found;
        }
        problems.push_with(|| self.not_found(name, place));
        None
    }

    fn not_found(&self, name: &str, place: &Place) -> Problem {
        let names = || self.names.iter().map(String::as_str);
        let label = nearest(name, names()).map(|near| format!("did you mean `{near}`?"));
        let title = format!("no material is named `{}`", shown(name));
        let help = match self.names.len() {
            0 => "there are none: they stand in `materials: { \"name\": Lambert(…) }`".to_string(),
            _ => format!("the materials are {}", quoted_list(names())),
        };
        place.labelled(title, label.unwrap_or_default()).with_help(help)
    }
}
