//! Warnings about surfaces that lie in one place in a scene.

use super::counter::Counter;
use crate::Warning;
use traylib_scene::{Coincidences, Scene};

/// Warns of lamps and of a camera that lay in one place with something else.
pub(super) fn warnings(scene: &Scene, file: &str) -> impl Iterator<Item = Warning> {
    let Coincidences { lifted_lights, points_in_surfaces, surfaces_at_camera } =
        scene.coincidences();
    let mut counter = Counter::default();
    counter.add_many(
        "lamp in one place with another surface: lifted off it, so that it shines \
         (of lamps in one place the first in the file does)",
        count(lifted_lights),
    );
    counter.add_many(
        "point light that lies in a surface: it shines on both sides of it",
        count(points_in_surfaces),
    );
    counter.add_many(
        "surface in which the camera lies: it is seen from a little off it, on the side \
         into which the camera looks",
        count(surfaces_at_camera),
    );
    counter.into_warnings(file)
}

fn count(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
