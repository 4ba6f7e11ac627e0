//! Lights that are not objects.

use super::files::SceneFile;
use super::place::Place;
use crate::locate::{Path, Step};
use crate::report::Problems;
use crate::ron_scene::{Light, SpotLight};
use traylib_math::{Rgb, Vec3};
use traylib_scene::{Error, PointLight, SceneBuilder, SpotCone};

/// The lights of all files that make sense.
pub(super) fn collect(files: &[SceneFile], problems: &mut Problems) -> Vec<PointLight> {
    let mut lights = Vec::new();
    for file in files {
        for (index, light) in file.document.lights.iter().enumerate() {
            let place = file.place(Path::of("lights").then(Step::Index(index)));
            let position = Vec3::from(light.position());
            if !position.is_finite() {
                problems.push(place.field("position").problem("the position must be finite"));
            }
            let intensity = Rgb::from(light.intensity());
            place.field("intensity").check_light("intensity", intensity, problems);
            let cone = match light {
                Light::Point(_) => None,
                Light::Spot(spot) => place.note(cone(spot, &place, problems), problems),
            };
            lights.push(PointLight { position, intensity, cone });
        }
    }
    lights
}

fn cone(spot: &SpotLight, place: &Place, problems: &mut Problems) -> Result<SpotCone, Error> {
    let (full, dark) = (spot.full, spot.dark.unwrap_or(spot.full));
    if !(0.0 <= full && full <= dark && 0.0 < dark && dark <= 360.0) {
        let message = "the angles must obey 0 ≤ `full` ≤ `dark` ≤ 360, and be more than 0";
        problems.push(place.field("full").problem(message));
    }
    let axis = Vec3::from(spot.target) - Vec3::from(spot.position);
    let [full, dark] = [full, dark].map(|whole| (0.5 * whole).to_radians().cos());
    // What has been refused already shall not be refused twice.
    let sound = if full >= dark { [full, dark] } else { [1.0, -1.0] };
    SpotCone::new(axis, sound[0], sound[1])
}

/// Adds a light of either kind.
pub(super) fn add_light(builder: &mut SceneBuilder, light: PointLight) -> Result<(), Error> {
    let PointLight { position, intensity, cone } = light;
    match cone {
        Some(cone) => builder.add_spot_light(position, intensity, cone),
        None => builder.add_point_light(position, intensity),
    }
}
