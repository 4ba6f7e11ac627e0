//! Draws skies.

use super::Dice;
use crate::relations::scene::Sky;
use traylib_math::Vec3;

/// What the dice are for: apart from all others, so that scenes are what they were before there
/// were skies.
const PURPOSE: u64 = 1000;

/// Radiance of texels; a Radiance picture holds these exactly.
const DULL: [Vec3; 4] =
    [Vec3::ZERO, Vec3::splat(0.5), Vec3::new(1.0, 0.5, 0.25), Vec3::new(0.25, 0.5, 1.0)];

/// Perhaps a sky for the scene of this number: the same all around, or a small picture with a
/// sun in it.
pub(super) fn some(seed: u64, number: u64) -> Option<Sky> {
    let mut dice = Dice::for_use(seed, number, PURPOSE);
    if dice.chance(0.5) {
        return None;
    }
    if dice.chance(0.4) {
        return Some(Sky::even(Vec3::splat(dice.between(0.1, 2.0))));
    }
    let (width, height) = (dice.pick(&[1, 2, 5, 8]), dice.pick(&[2, 3, 6]));
    let mut texels: Vec<Vec3> = (0..width * height).map(|_| dice.pick(&DULL)).collect();
    let sun = dice.below(texels.len() as u32) as usize;
    texels[sun] = Vec3::splat(dice.pick(&[1.0, 8.0, 64.0]));
    Some(Sky { width, texels, turn: dice.pick(&[0.0, 90.0, 37.5]) })
}
