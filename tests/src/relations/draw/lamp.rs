//! Lamps of every shape.

use super::enclosure::Enclosure;
use super::{Dice, material, shape};
use crate::relations::scene::{Base, Lobes, Material, Object, Shape};
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// Adds a lamp somewhere in a space: at its ceiling, free, or instead of a wall.
pub(super) fn hang(dice: &mut Dice, space: &Enclosure, objects: &mut Vec<Object>) {
    let size = space.size() * dice.pick(&[0.02, 0.1, 0.2, 0.3]);
    let place = space.place(dice);
    let shape = match dice.below(8) {
        0..=2 => ceiling(dice, space, size),
        3 => shape::tube(dice, place, size),
        4 => shape::mesh(dice, place, size),
        _ => shape::any(dice, place, size),
    };
    let material = lamp_material(dice, &shape);
    let emission = radiance(dice) * brightness(space, size);
    let sides = if dice.chance(0.3) { Sides::Front } else { Sides::Both };
    let lamp = Object { shape, material, emission, sides };
    if dice.chance(0.3) { objects.insert(0, lamp) } else { objects.push(lamp) }
}

/// Returns the factor that makes what is lit about as bright as one.
fn brightness(space: &Enclosure, size: f32) -> f32 {
    (space.size() / size).powi(2).min(100.0)
}

fn radiance(dice: &mut Dice) -> Vec3 {
    if dice.chance(0.7) {
        Vec3::splat(dice.pick(&[0.25, 1.0, 0.7]))
    } else {
        material::colour(dice, 1.0) + 0.05
    }
}

/// Facing down: in the plane of the ceiling, a little below, or a good deal.
fn ceiling(dice: &mut Dice, space: &Enclosure, size: f32) -> Shape {
    let below = dice.pick(&[0.0, 1e-3, 0.125, 0.3]) * space.size();
    let place = space.place(dice);
    let place = Vec3::new(place.x, space.max.y - below, place.z);
    shape::flat_facing(dice, place, Vec3::NEG_Y, size)
}

/// Mostly black; some reflect, let light through, or have pictures.
fn lamp_material(dice: &mut Dice, shape: &Shape) -> Material {
    match dice.below(10) {
        0 => Material::grey(0.5),
        1 | 4 => {
            let part = Lobes::diffuse(Vec3::splat(0.8));
            Material::plain(Base::Sheet(Lobes::NONE, part))
        }
        2 | 3 if shape.shows_pictures() => {
            Material { opacity: Some(material::map(dice, 255)), ..Material::grey(0.0) }
        }
        _ => Material::grey(0.0),
    }
}

/// A ball far away, as strong as it must be to light what is here.
pub(super) fn sun(dice: &mut Dice, space: &Enclosure) -> Object {
    let far = space.size() * 10.0_f32.powf(dice.between(1.0, 10.0));
    let centre = if dice.chance(0.5) { Vec3::Y * far } else { dice.direction() * far };
    Object {
        shape: Shape::Sphere { centre, radius: 0.005 * far, inward: false },
        material: Material::grey(0.0),
        emission: Vec3::splat(2e4),
        sides: Sides::Both,
    }
}
