//! Draws the cameras of scenes.

use super::enclosure::Enclosure;
use super::{Dice, number};
use crate::relations::scene::{Camera, Object};
use traylib_math::Vec3;

/// Pixels along either side of the film.
const PIXELS: u32 = 16;

/// In a space, outside of all boxes around small objects, looking at one of them.
pub(super) fn within(dice: &mut Dice, space: &Enclosure, objects: &[Object]) -> Camera {
    let mut position = space.place(dice);
    for _ in 0..20 {
        let is_inside = objects.iter().any(|object| {
            let bounds = object.shape.bounds();
            let is_small = bounds.extent().max_element() < 0.9 * space.extent().max_element();
            is_small && bounds.grown(Vec3::splat(0.02 * space.size())).contains(position)
        });
        if !is_inside {
            break;
        }
        position = space.place(dice);
    }
    let target = match dice.below(3) {
        0 => space.centre(),
        1 => space.place(dice),
        _ => {
            let object = dice.pick(objects);
            let middle = object.shape.bounds().centre();
            if object.is_light() && dice.chance(0.8) { space.place(dice) } else { middle }
        }
    };
    let away = (target - position).length();
    let target = if away < 1e-3 * space.size() { position + space.extent() } else { target };
    looking(dice, position, target)
}

/// From here to there.
pub(super) fn looking(dice: &mut Dice, position: Vec3, target: Vec3) -> Camera {
    let view = (target - position).normalize();
    let up = if view.y.abs() < 0.99 { Vec3::Y } else { Vec3::Z };
    let fov = number::between(dice, 15.0, 90.0);
    Camera { position, target, up, fov, pixels: PIXELS }
}
