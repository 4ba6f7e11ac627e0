//! The noise of a method as it is, by the numbers that a picture would have.

use super::bands::{bands, product};
use super::forecast::RARE;
use super::means::Passes;
use super::probes::{Probed, Probes};
use super::seen::LightsSeen;
use super::tiles::Tiles;
use crate::Method;

/// The light that a method found at the probes.
pub(super) struct Trial {
    /// Light of camera paths, pass by pass for each probe.
    own: Vec<[f64; 3]>,
    /// Variance of a sample by splats, relative as relMSE is.
    splats: f64,
}

impl Trial {
    /// Asks the probes by a method; for its light but for [`LightsSeen`], which are the same to
    /// all methods.
    ///
    /// Samples of more than [`RARE`] times the light around count as so many times: of what is as
    /// rare among so few a forecast knows more.
    pub(super) fn run(
        probes: &Probes<'_>,
        tiles: &Tiles,
        method: Method,
        seen: &LightsSeen,
    ) -> Self {
        let square = |pixel, light| tiles.weight(pixel) * product(light, light);
        let integrator = method.build();
        let Passes { points, count, .. } = seen.passes();
        let answers = probes.ask(&*integrator, points, count, |probe, pass, probed| {
            let Probed { radiance, splats, .. } = probed;
            let mut own = bands(radiance);
            own.iter_mut().zip(seen.of(probe, pass)).for_each(|(own, seen)| *own -= seen);
            let size = square(probes.pixels[probe], own).sqrt();
            if size > RARE {
                own = own.map(|band| band * RARE / size);
            }
            // Splats are rare in each pixel: their variance is their mean square.
            let splat = |(pixel, light)| square(pixel, bands(light)).min(RARE * RARE);
            (own, splats.into_iter().map(splat).sum::<f64>())
        });
        let (own, splats): (Vec<[f64; 3]>, Vec<f64>) = answers.into_iter().unzip();
        // One light path was asked for each sample, whatever their number in a pass.
        let splats =
            method.light_paths_per_pixel() * splats.iter().sum::<f64>() / splats.len() as f64;
        Self { own, splats }
    }

    /// Variance of one sample a pixel as means of many have it, where squares at the probes have
    /// these weights.
    pub(super) fn variance(&self, weights: &[f64], passes: Passes) -> f64 {
        passes.variance(&self.own, weights) + self.splats
    }
}

/// Returns the factors of squares at each probe: as [`Tiles`] has it, but by the light of the probe
/// itself, which so many samples tell. The most that any method has counts, since camera paths of
/// some leave a part of it to splats.
pub(super) fn weights(trials: &[Trial], tiles: &Tiles, seen: &LightsSeen) -> Vec<f64> {
    let count = seen.passes().count as usize;
    let probes = trials.first().map_or(0, |trial| trial.own.len() / count);
    let light = |probe: usize, trial: &Trial| {
        let values = &trial.own[probe * count..][..count];
        let sum: f64 = values.iter().flatten().sum();
        sum / (3 * count) as f64
    };
    let weight = |probe| {
        let most = trials.iter().map(|trial| light(probe, trial)).fold(0.0, f64::max);
        let light = most + seen.mean_of(probe);
        1.0 / (light * light + tiles.dark())
    };
    (0..probes).map(weight).collect()
}
