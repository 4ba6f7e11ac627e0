//! Materials: from documents to models, and by name.

use super::files::SceneFile;
use super::place::Place;
use crate::report::Problem;
use crate::ron_scene::Material;
use crate::ron_scene::locate::{Path, Step};
use crate::suggest::{nearest, quoted_list};
use std::collections::HashMap;
use traylib_materials::{Error, Lambert, MaxPhong, Mirror, Phong, SurfaceModel};
use traylib_math::Rgb;

/// The named materials of all files.
pub(super) struct Materials {
    models: Vec<traylib_materials::Material>,
    /// `None` is a material that has an error of its own.
    by_name: HashMap<String, Option<usize>>,
    /// In file order, for messages.
    names: Vec<String>,
}

impl Materials {
    pub(super) fn collect(files: &[SceneFile], problems: &mut Vec<Problem>) -> Self {
        let mut materials = Self { models: Vec::new(), by_name: HashMap::new(), names: Vec::new() };
        for file in files {
            for (index, (name, material)) in file.document.materials.0.iter().enumerate() {
                let path = Path::of("materials");
                let key = file.place(path.then(Step::Key(index)));
                let value = file.place(path.then(Step::Value(index)));
                materials.add(name, material, &key, &value, problems);
            }
        }
        materials
    }

    fn add(
        &mut self,
        name: &str,
        material: &Material,
        key: &Place,
        value: &Place,
        problems: &mut Vec<Problem>,
    ) {
        if self.by_name.contains_key(name) {
            problems.push(key.labelled(format!("two materials are named `{name}`"), "the second"));
            return;
        }
        let index = match surface_model(material) {
            Ok(model) => {
                self.models.push(model.into());
                Some(self.models.len() - 1)
            }
            Err(error) => {
                problems.push(faulty_part(value, &error).problem(error));
                None
            }
        };
        self.by_name.insert(name.to_string(), index);
        self.names.push(name.to_string());
    }

    /// The models, by the numbers that [`find`](Self::find) gives.
    pub(super) fn models(&self) -> &[traylib_materials::Material] {
        &self.models
    }

    /// The number of a material's model.
    pub(super) fn find(
        &self,
        name: &str,
        place: &Place,
        problems: &mut Vec<Problem>,
    ) -> Option<usize> {
        if let Some(found) = self.by_name.get(name) {
            return *found;
        }
        let names = || self.names.iter().map(String::as_str);
        let label = nearest(name, names()).map(|near| format!("did you mean `{near}`?"));
        let title = format!("no material is named `{name}`");
        let problem = place.labelled(title, label.unwrap_or_default());
        problems.push(problem.with_help(format!("the materials are {}", quoted_list(names()))));
        None
    }
}

fn surface_model(material: &Material) -> Result<SurfaceModel, Error> {
    Ok(match material {
        Material::Lambert(m) => SurfaceModel::Lambert(Lambert::new(Rgb::from(m.reflectance))?),
        Material::Phong(m) => {
            let (diffuse, specular) = (Rgb::from(m.diffuse), Rgb::from(m.specular));
            SurfaceModel::Phong(Phong::new(diffuse, specular, m.exponent)?)
        }
        Material::MaxPhong(m) => {
            SurfaceModel::MaxPhong(MaxPhong::new(Rgb::from(m.specular), m.exponent)?)
        }
        Material::Mirror(m) => {
            let (reflectance, diffuse) = (Rgb::from(m.reflectance), Rgb::from(m.diffuse));
            SurfaceModel::Mirror(Mirror::new(reflectance, diffuse)?)
        }
    })
}

/// The field that an error is about; errors name the fields as files do.
fn faulty_part(value: &Place, error: &Error) -> Place {
    match error {
        Error::Reflectance { name, .. } => value.field(name),
        Error::Exponent(_) => value.field("exponent"),
        _ => value.clone(),
    }
}
