//! Draws scenes: rooms, plates under lamps, objects in a dome, balls in the dark; of every shape
//! and material, at places and angles that people use on purpose.

mod camera;
mod dice;
mod enclosure;
mod lamp;
mod material;
mod number;
mod picture;
mod shape;
mod sky;

pub use dice::Dice;

use crate::relations::scene::{Base, DrawnScene, Light, Material, Object, Shape, Spot};
use enclosure::Enclosure;
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// The scene of this number in the run with this seed.
pub fn scene(seed: u64, number: u64) -> DrawnScene {
    let mut dice = Dice::new(seed, number);
    match dice.below(10) {
        0..=3 => room(&mut dice),
        4..=6 => dome(&mut dice),
        7 | 8 => DrawnScene { sky: sky::some(seed, number), ..open(&mut dice) },
        _ => DrawnScene { sky: sky::some(seed, number), ..space(&mut dice) },
    }
}

/// Walls all around, lamps and objects within.
fn room(dice: &mut Dice) -> DrawnScene {
    let space = enclosure::extent(dice);
    let mut objects = enclosure::walls(dice, &space);
    let count = dice.below(4);
    let lamps = if dice.chance(0.25) { 2 + dice.below(2) } else { 1 };
    let mut lights = Vec::new();
    for _ in 0..lamps {
        if dice.chance(0.12) {
            lights.push(light(dice, &space));
        } else {
            lamp::hang(dice, &space, &mut objects);
        }
    }
    for _ in 0..count {
        let object = object(dice, &space);
        objects.push(object);
    }
    if dice.chance(0.1) {
        objects.push(lamp::sun(dice, &space));
    }
    finish(dice, &space, objects, lights)
}

/// A sky that shines from all around.
fn dome(dice: &mut Dice) -> DrawnScene {
    let space = Enclosure::around_origin(number::size(dice, 0.5, 4.0));
    let mut objects = vec![enclosure::sky(dice, &space)];
    for _ in 0..=dice.below(5) {
        let object = if dice.chance(0.5) { plate(dice, &space) } else { object(dice, &space) };
        objects.push(object);
    }
    if dice.chance(0.2) {
        lamp::hang(dice, &space, &mut objects);
    }
    let lights = if dice.chance(0.1) { vec![light(dice, &space)] } else { Vec::new() };
    finish(dice, &space, objects, lights)
}

/// A floor under lamps, and darkness or a sky around.
fn open(dice: &mut Dice) -> DrawnScene {
    let space = enclosure::extent(dice);
    let mut objects = vec![enclosure::floor(dice, &space)];
    let mut lights = Vec::new();
    for _ in 0..=dice.below(3) {
        if dice.chance(0.3) {
            lights.push(light(dice, &space));
        } else {
            lamp::hang(dice, &space, &mut objects);
        }
    }
    for _ in 0..dice.below(4) {
        let object = object(dice, &space);
        objects.push(object);
    }
    finish(dice, &space, objects, lights)
}

/// Balls far apart, of any size, perhaps under a sky.
fn space(dice: &mut Dice) -> DrawnScene {
    let unit = 10.0_f32.powf(dice.between(-6.0, 12.0)) * if dice.chance(0.5) { 1.0 } else { 0.7 };
    let axis = dice.pick(&[Vec3::X, Vec3::Y, Vec3::Z]);
    let across = Vec3::new(axis.z, axis.x, axis.y);
    let ball = |place: f32, off: f32, radius: f32, reflectance: f32| Object {
        shape: Shape::Sphere {
            centre: (axis * place + across * off) * unit,
            radius: radius * unit,
            inward: false,
        },
        material: Material::grey(reflectance),
        emission: Vec3::ZERO,
        sides: Sides::Both,
    };
    let mut sun = ball(0.0, 0.0, dice.between(0.05, 0.8), 0.0);
    sun.emission = Vec3::splat(dice.between(1.0, 20.0));
    let moon_at = dice.between(4.0, 12.0);
    let size = dice.between(0.1, 0.6);
    let moon = ball(moon_at, 0.0, size, dice.pick(&[0.2, 0.5, 0.8]));
    let mut objects = vec![sun, moon];
    if dice.chance(0.7) {
        let (off, radius) = (dice.pick(&[0.0, 0.0, 0.3]), dice.between(0.2, 0.9));
        objects.push(ball(moon_at * dice.between(0.3, 0.8), off, radius, 0.3));
    }
    let eye = axis * (moon_at - 3.0 * size) + across * size * dice.pick(&[0.0, 1.0, 2.5]);
    let camera = camera::looking(dice, eye * unit, axis * moon_at * unit);
    let max_depth = Some(2 + dice.below(2));
    DrawnScene { camera, objects, lights: Vec::new(), sky: None, max_depth }
}

fn finish(
    dice: &mut Dice,
    space: &Enclosure,
    mut objects: Vec<Object>,
    mut lights: Vec<Light>,
) -> DrawnScene {
    if !lights.is_empty() && dice.chance(0.15) {
        lights[0].position = on_a_ball(dice, space, &mut objects);
        lights[0].spot = None;
    }
    let camera = camera::within(dice, space, &objects);
    let max_depth = Some(dice.pick(&[2, 2, 3, 3, 4, 5, 6]));
    let mut scene = DrawnScene { camera, objects, lights, sky: None, max_depth };
    scene.light_up();
    scene
}

/// A point of a ball that is put up for it.
fn on_a_ball(dice: &mut Dice, space: &Enclosure, objects: &mut Vec<Object>) -> Vec3 {
    let (centre, radius) = (space.place(dice), space.size() * dice.pick(&[0.125, 0.2]));
    let shape = Shape::Sphere { centre, radius, inward: false };
    let material = Material::grey(0.5);
    objects.push(Object { shape, material, emission: Vec3::ZERO, sides: Sides::Both });
    let direction = if dice.chance(0.6) { dice.axis() } else { dice.direction() };
    centre + direction * radius
}

/// An object of any shape somewhere in a space, rather on its floor.
fn object(dice: &mut Dice, space: &Enclosure) -> Object {
    let size = space.size() * dice.between(0.08, 0.3);
    let place = space.place(dice);
    let mut shape = shape::any(dice, place, size);
    if dice.chance(0.4) {
        // It stands on the floor, and touches it.
        let down = space.min.y - shape.bounds().min.y;
        shape = shape::moved(&shape, Vec3::Y * down);
    }
    let material = material::any(dice, &shape);
    let is_glass = matches!(material.base, Base::Glass(_));
    let sides = if dice.chance(0.12) && !is_glass { Sides::Front } else { Sides::Both };
    Object { material, shape, emission: Vec3::ZERO, sides }
}

/// Something flat, rather in a plane of two axes.
fn plate(dice: &mut Dice, space: &Enclosure) -> Object {
    let place = if dice.chance(0.6) { Vec3::ZERO } else { space.place(dice) };
    let size = space.size() * dice.between(0.2, 0.6);
    let shape = shape::flat(dice, place, size);
    let sides = if dice.chance(0.2) { Sides::Front } else { Sides::Both };
    Object { material: material::any(dice, &shape), shape, emission: Vec3::ZERO, sides }
}

fn light(dice: &mut Dice, space: &Enclosure) -> Light {
    let position = space.place(dice);
    let strength = space.size() * space.size() * dice.between(0.2, 2.0);
    let intensity = material::colour(dice, 1.0) * strength + 0.01 * strength;
    let spot = dice.chance(0.3).then(|| {
        let full = dice.pick(&[10.0, 40.0, 90.0]);
        Spot { target: space.place(dice), full, dark: full * dice.pick(&[1.0, 1.5, 1.9]) }
    });
    let spot = spot.filter(|spot| spot.target != position);
    Light { position, intensity, spot }
}
