//! The sky of a scene file.

use super::files::SceneFile;
use super::place::Place;
use super::sky_light::SkyLight;
use super::textures::Textures;
use crate::locate::Path;
use crate::report::Problems;
use crate::ron_scene::{PictureSky, Sky};
use traylib_math::{Grid, Rgb};

/// A sky with its place in the scene file.
pub(super) struct ImportedSky {
    pub(super) light: SkyLight,
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
                Some(Self { light: SkyLight::constant(light), place })
            }
            Sky::Picture(sky) => {
                let radiance = picture(file, sky, &place, textures, problems)?;
                Some(Self { light: SkyLight { radiance, turn_degrees: sky.turn }, place })
            }
        }
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
