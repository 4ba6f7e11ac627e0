//! The choice of the best filter for each place.

use super::{Picture, smooth};
use traylib_math::{Grid, Vec3};

/// A picture, and about how large the square of its error is in each pixel.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) picture: Picture,
    /// Unbiased but noisy: it may be negative.
    pub(super) error: Picture,
}

/// Errors are told apart by means over squares that reach this far.
const ERROR_RADIUS: usize = 5;
/// From one choice to the next there are so many pixels of both.
const BLEND_RADIUS: usize = 2;
/// The part of the mean below which errors are weighed as if the picture were that bright: that of
/// relMSE.
const DARK: f32 = 0.1;

/// Returns a picture that takes every place from the candidate with the least error there,
/// relative to the light of `whole`.
pub(super) fn best_of(candidates: &[Candidate], whole: &Picture) -> Picture {
    let weights = weights(whole);
    let errors: Vec<Grid<f32>> = candidates
        .iter()
        .map(|Candidate { error, .. }| {
            let (error, weights) = (error.values(), weights.values());
            let relative = |i: usize| error[i].dot(weights[i]);
            smooth::mean(&Grid::from_fn(whole.width(), whole.height(), relative), ERROR_RADIUS)
        })
        .collect();
    let best = Grid::from_fn(whole.width(), whole.height(), |i| {
        let error = |candidate: &usize| errors[*candidate].values()[i];
        (0..candidates.len()).min_by(|a, b| error(a).total_cmp(&error(b))).unwrap_or(0)
    });
    let mut sum = Grid::filled(whole.width(), whole.height(), Vec3::ZERO);
    for (index, Candidate { picture, .. }) in candidates.iter().enumerate() {
        let share = smooth::mean(&best.map(|&best| f32::from(best == index)), BLEND_RADIUS);
        let light = picture.values().iter().zip(share.values());
        for (sum, (&light, &share)) in sum.values_mut().iter_mut().zip(light) {
            *sum += light * share;
        }
    }
    sum
}

/// One over the square of the light: of the pixel and of those around it, which know more.
fn weights(whole: &Picture) -> Picture {
    let count = whole.values().len().max(1) as f32;
    let mean = whole.values().iter().sum::<Vec3>() / count;
    let dark = DARK * DARK * mean.dot(mean) / 3.0 + f32::MIN_POSITIVE;
    let around = smooth::mean(whole, BLEND_RADIUS);
    let (own, around) = (whole.values(), around.values());
    Grid::from_fn(whole.width(), whole.height(), |i| {
        (0.5 * (own[i] * own[i] + around[i] * around[i]) + Vec3::splat(dark)).recip()
    })
}
