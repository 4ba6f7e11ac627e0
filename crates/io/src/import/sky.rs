//! The sky of a scene file.

use super::files::SceneFile;
use super::place::Place;
use super::scene_parts::PartSky;
use super::textures::Textures;
use crate::locate::Path;
use crate::report::Problems;
use crate::ron_scene::{PictureSky, Sky};
use std::sync::Arc;
use traylib_materials::Texture;
use traylib_math::{Grid, Rgb};

/// A sky as the builder of a scene takes it.
pub(super) struct ImportedSky {
    /// W/(m²·sr), row by row from the top; one texel if it is the same everywhere.
    pub(super) radiance: Grid<Rgb>,
    pub(super) turn_degrees: f32,
    pub(super) place: Place,
}

impl ImportedSky {
    /// The sky of a file, unless it has none, or none that makes sense.
    pub(super) fn of(
        file: &SceneFile,
        textures: &mut Textures,
        problems: &mut Problems,
    ) -> Option<Self> {
        let place = file.place(Path::of("sky"));
        match file.document.sky.as_ref()? {
            Sky::Constant(sky) => {
                let light = Rgb::from(sky.radiance);
                place.field("radiance").check_light("radiance", light, problems);
                let radiance = Grid::filled(1, 1, light);
                Some(Self { radiance, turn_degrees: 0.0, place })
            }
            Sky::Picture(sky) => {
                let radiance = picture(file, sky, &place, textures, problems)?;
                Some(Self { radiance, turn_degrees: sky.turn, place })
            }
        }
    }

    /// What is kept of it to write it again; `None` if it has no texels.
    pub(super) fn as_part(&self) -> Option<PartSky> {
        let radiance = Arc::new(Texture::new(self.radiance.clone())?);
        Some(PartSky { radiance, turn_degrees: self.turn_degrees })
    }

    /// Whether light comes from anywhere.
    pub(super) fn is_lit(&self) -> bool {
        self.radiance.values().iter().any(|light| !light.is_black())
    }
}

fn picture(
    file: &SceneFile,
    sky: &PictureSky,
    place: &Place,
    textures: &mut Textures,
    problems: &mut Problems,
) -> Option<Grid<Rgb>> {
    if !(sky.scale >= 0.0 && sky.scale.is_finite()) {
        let place = place.field("scale");
        problems.push(place.problem("the scale must be finite and not negative"));
    }
    if !sky.turn.is_finite() {
        problems.push(place.field("turn").problem("the turn must be finite"));
    }
    let location = file.location.beside(&sky.file);
    let light = textures.load_light(&location, sky.scale).map_err(|error| {
        let problem = place.field("file").problem(error);
        problems.push(problem.with_help_if_any(location.advice(&sky.file)));
    });
    light.ok()
}
