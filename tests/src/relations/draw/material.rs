//! Materials of any kind.

use super::{Dice, picture};
use crate::relations::scene::{Base, BumpMap, Lobes, Map, Material, Shape, Tiling};
use traylib_math::{Vec2, Vec3};

/// The material of an object of this shape; with pictures where it shows them.
pub(super) fn any(dice: &mut Dice, shape: &Shape) -> Material {
    let base = match dice.below(16) {
        0..=6 => Base::Lambert(colour(dice, 0.9)),
        7 | 8 => Base::Phong(lobes(dice, 0.9)),
        9 => Base::MaxPhong(colour(dice, 0.9), exponent(dice)),
        10 => Base::Mirror(colour(dice, 0.5), colour(dice, 0.4)),
        11 => Base::Mirror(colour(dice, 0.9), Vec3::ZERO),
        12 | 13 => sheet(dice),
        14 => Base::Pane(
            if dice.chance(0.5) { Vec3::ZERO } else { colour(dice, 0.3) },
            colour(dice, 0.6),
        ),
        _ if shape.is_solid() => Base::Glass(dice.pick(&[1.5, 1.33, 2.0])),
        _ => sheet(dice),
    };
    let plain = Material::plain(base);
    if shape.shows_pictures() && dice.chance(0.35) { dressed(dice, plain) } else { plain }
}

/// Draws the material of a wall: mostly dull.
pub(super) fn wall(dice: &mut Dice) -> Material {
    match dice.below(12) {
        0 => Material::plain(Base::Phong(lobes(dice, 0.8))),
        1 => Material::plain(Base::Mirror(Vec3::splat(0.4), Vec3::splat(0.4))),
        _ => Material::plain(Base::Lambert(colour(dice, 0.8))),
    }
}

/// A colour, rather grey, no band of it over `most`.
pub(super) fn colour(dice: &mut Dice, most: f32) -> Vec3 {
    let grey = dice.pick(&[0.0, 0.2, 0.5, 0.8, 1.0]) * most;
    if dice.chance(0.6) {
        return Vec3::splat(grey);
    }
    Vec3::from_array([0; 3].map(|_| dice.between(0.0, most)))
}

fn exponent(dice: &mut Dice) -> f32 {
    dice.pick(&[1.0, 1.0, 5.0, 20.0, 60.0, 1000.0])
}

fn lobes(dice: &mut Dice, most: f32) -> Lobes {
    let share = dice.pick(&[0.2, 0.5, 0.8]);
    Lobes {
        diffuse: colour(dice, most * share),
        specular: colour(dice, most * (1.0 - share)),
        exponent: exponent(dice),
    }
}

fn sheet(dice: &mut Dice) -> Base {
    let share = dice.pick(&[0.0, 0.3, 0.5]);
    let reflection = if share == 0.0 { Lobes::NONE } else { lobes(dice, 0.9 * share) };
    Base::Sheet(reflection, lobes(dice, 0.9 * (1.0 - share)))
}

/// With pictures where the model takes them.
fn dressed(dice: &mut Dice, plain: Material) -> Material {
    let mut material = plain;
    let takes_diffuse = matches!(material.base, Base::Lambert(_) | Base::Phong(_));
    if takes_diffuse && dice.chance(0.6) {
        // Half at most: a lobe beside it reflects as much at most.
        if let Base::Phong(lobes) = &mut material.base {
            lobes.specular = lobes.specular.min(Vec3::splat(0.4));
            lobes.diffuse = lobes.diffuse.min(Vec3::splat(0.4));
        }
        material.diffuse = Some(map(dice, 120));
    }
    if dice.chance(0.4) {
        material.opacity = Some(map(dice, 255));
    }
    if dice.chance(0.3) {
        let map = map(dice, 255);
        material.bump = Some(BumpMap { map, height: dice.pick(&[0.01, 0.05, 0.2]) });
    }
    material
}

/// A picture of values up to `most` that lies somehow.
pub(super) fn map(dice: &mut Dice, most: u8) -> Map {
    Map {
        picture: picture::any(dice, most),
        tiling: dice.pick(&[Tiling::Repeat, Tiling::Repeat, Tiling::Mirror, Tiling::Once]),
        scale: dice.pick(&[Vec2::ONE, Vec2::ONE, Vec2::new(2.0, 3.0), Vec2::new(0.5, 0.75)]),
        strength: dice.pick(&[1.0, 1.0, 0.5]),
    }
}
