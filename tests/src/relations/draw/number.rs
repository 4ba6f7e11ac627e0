//! Numbers as people write them.

use super::Dice;

/// A number of this range: half of them halves and eighths, some with one decimal
/// digit, the others as they come.
pub(super) fn between(dice: &mut Dice, low: f32, high: f32) -> f32 {
    let number = dice.between(low, high);
    let rounded = match dice.below(8) {
        0..=2 => (number * 2.0).round() / 2.0,
        3 => (number * 8.0).round() / 8.0,
        4 | 5 => (number * 10.0).round() / 10.0,
        _ => number,
    };
    if rounded > low && rounded < high { rounded } else { number }
}

/// A length of this range, its logarithm even.
pub(super) fn size(dice: &mut Dice, low: f32, high: f32) -> f32 {
    let number = low * (high / low).powf(dice.even());
    match dice.below(4) {
        0 => number.log2().round().exp2(),
        1 => (number * 10.0).ceil() / 10.0,
        _ => number,
    }
}
