//! Pictures of a few pixels.

use super::Dice;
use crate::relations::scene::{Coding, Picture};

/// Draws a picture of one pixel, in halves, or speckled; grey or coloured, values up to `most`.
pub(super) fn any(dice: &mut Dice, most: u8) -> Picture {
    let [width, height] = dice.pick(&[[1, 1], [2, 1], [1, 2], [2, 2], [4, 4]]);
    let is_grey = dice.chance(0.6);
    let is_sharp = dice.chance(0.5);
    let value = |dice: &mut Dice| {
        let part = if is_sharp { dice.pick(&[0.0, 1.0]) } else { dice.even() };
        // Even: three ones are a run in old Radiance pictures.
        (part * f32::from(most)) as u8 & !1
    };
    let texel = |dice: &mut Dice| {
        let grey = value(dice);
        if is_grey { [grey; 3] } else { [grey, value(dice), value(dice)] }
    };
    let texels = (0..width * height).map(|_| texel(dice)).collect();
    Picture::Texels { width, texels, coding: dice.pick(&[Coding::Hdr, Coding::Tga]) }
}
