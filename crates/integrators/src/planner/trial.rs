//! The noise of a method as it is, by the numbers that a picture would have.

use super::bands::{bands, product};
use super::means::Passes;
use super::probes::{Probed, Probes};
use super::tiles::Tiles;
use crate::{BdptSettings, Method};

/// Variance of one sample a pixel, relative as relMSE is, as means of many have it; but for
/// [`edges_of_lights`], which is the same to all methods.
///
/// Samples of more than `clip` times the light around count as so many times: of what is as
/// rare among so few a forecast knows more.
pub(super) fn trial(
    probes: &Probes<'_>,
    tiles: &Tiles,
    method: Method,
    passes: Passes,
    clip: f64,
) -> f64 {
    let seen = seen(probes, passes);
    let square = |pixel, light| tiles.weight(pixel) * product(light, light);
    let integrator = method.build();
    let answers = probes.ask(&*integrator, passes.points, passes.count, |probe, pass, probed| {
        let Probed { radiance, splats, .. } = probed;
        let mut own = bands(radiance);
        let seen = seen[probe * passes.count as usize + pass as usize];
        own.iter_mut().zip(seen).for_each(|(own, seen)| *own -= seen);
        let size = square(probes.pixels[probe], own).sqrt();
        if size > clip {
            own = own.map(|band| band * clip / size);
        }
        // Splats are rare in each pixel: their variance is their mean square.
        let splat = |(pixel, light)| square(pixel, bands(light)).min(clip * clip);
        (own, splats.into_iter().map(splat).sum::<f64>())
    });
    let (own, splats): (Vec<[f64; 3]>, Vec<f64>) = answers.into_iter().unzip();
    let weights: Vec<f64> = probes.pixels.iter().map(|&pixel| tiles.weight(pixel)).collect();
    // One light path was asked for each sample, whatever their number in a pass.
    let splats = light_paths(method) * splats.iter().sum::<f64>() / splats.len() as f64;
    passes.variance(&own, &weights) + splats
}

/// The same of what the camera sees of lights themselves, where their edges cross pixels.
pub(super) fn edges_of_lights(probes: &Probes<'_>, tiles: &Tiles, passes: Passes) -> f64 {
    let seen = seen(probes, passes);
    // Where a light is seen it is most of the light of the place.
    let of_probes = seen.chunks(passes.count as usize).zip(&probes.pixels);
    let weights = of_probes.map(|(seen, &pixel)| {
        let mean =
            |band: usize| seen.iter().map(|seen| seen[band]).sum::<f64>() / seen.len() as f64;
        let mean = [0, 1, 2].map(mean);
        1.0 / (1.0 / tiles.weight(pixel) + product(mean, mean))
    });
    passes.variance(&seen, &weights.collect::<Vec<f64>>())
}

/// What the camera sees of lights themselves, by the rays that all methods begin with.
fn seen(probes: &Probes<'_>, passes: Passes) -> Vec<[f64; 3]> {
    let lights = Method::PURE_MC.up_to(Some(1)).build();
    probes.ask(&*lights, passes.points, passes.count, |_, _, probed| bands(probed.radiance))
}

/// Light paths for each pixel of a pass.
fn light_paths(method: Method) -> f64 {
    match method {
        Method::Bdpt(BdptSettings { light_paths, .. }) => light_paths.ratio(),
        Method::Trace(_) | Method::PureMc(_) | Method::DirectLight(_) | Method::Particle(_) => 1.0,
    }
}
