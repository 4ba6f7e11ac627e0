//! The noise of a method as it is, by the numbers that a picture would have.

use super::probes::{Probed, Probes};
use super::tiles::{Tiles, bands, product};
use crate::{BdptSettings, Method, PointSet};

/// Variance of one sample a pixel, relative as relMSE is, from `passes` of every probe: that
/// of a mean of them, times their number, since quasi-random points make means better than
/// their samples are.
pub(super) fn trial(
    probes: &Probes<'_>,
    tiles: &Tiles,
    method: Method,
    points: PointSet,
    passes: u32,
) -> f64 {
    let integrator = method.build();
    // Lamps that the camera sees are left out, as of the pilot: by the same rays alone.
    let seen = Method::PURE_MC.up_to(Some(1)).build();
    let seen = probes.ask(&*seen, points, passes, |_, _, probed| probed.radiance);
    let answers = probes.ask(&*integrator, points, passes, |probe, pass, probed| {
        // Splats are rare in each pixel: their variance is their mean square.
        let splat = |(pixel, light)| tiles.weight(pixel) * product(bands(light), bands(light));
        let Probed { radiance, splats, .. } = probed;
        let (mut rest, seen) = (bands(radiance), seen[probe * passes as usize + pass as usize]);
        rest.iter_mut().zip(bands(seen)).for_each(|(rest, seen)| *rest -= seen);
        (rest, splats.into_iter().map(splat).sum::<f64>())
    });
    let samples = answers.len() as f64;
    let splatted: f64 = answers.iter().map(|(_, squares)| squares).sum();
    // One light path was asked for each sample, whatever their number in a pass.
    let splats = splatted / samples * light_paths(method);
    let own = answers.chunks(passes as usize).zip(&probes.pixels).map(|(answers, &pixel)| {
        let values = answers.iter().map(|(radiance, _)| *radiance);
        tiles.weight(pixel) * variance_of_sample(values, points.sequences())
    });
    splats + own.sum::<f64>() / probes.pixels.len() as f64
}

/// Light paths for each pixel of a pass.
fn light_paths(method: Method) -> f64 {
    match method {
        Method::Bdpt(BdptSettings { light_paths, .. }) => light_paths.ratio(),
        Method::Trace(_) | Method::PureMc(_) | Method::DirectLight(_) | Method::Particle(_) => 1.0,
    }
}

/// Variance of the mean of all values times their number, from means of the sequences that
/// they belong to by turns; of those that are each a sequence of their own, the usual.
fn variance_of_sample(values: impl Iterator<Item = [f64; 3]>, sequences: u32) -> f64 {
    let values: Vec<[f64; 3]> = values.collect();
    let groups = if sequences > 1 { sequences as usize } else { values.len() };
    let in_group = (values.len() / groups) as f64;
    let mut means = vec![[0.0; 3]; groups];
    for (i, value) in values.iter().enumerate() {
        for (mean, band) in means[i % groups].iter_mut().zip(value) {
            *mean += band / in_group;
        }
    }
    let n = groups as f64;
    let band = |band: usize| {
        let mean = means.iter().map(|m| m[band]).sum::<f64>() / n;
        means.iter().map(|m| (m[band] - mean).powi(2)).sum::<f64>() / (n - 1.0)
    };
    // Of one group's mean; a sample's is as many times more as it has samples.
    in_group * (0..3).map(band).sum::<f64>() / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sequences_are_the_unit() {
        let grey = |values: &[f64]| values.iter().map(|&v| [v; 3]).collect::<Vec<_>>();
        // Means 1 and 3 of two samples each.
        let even = grey(&[0.0, 2.0, 2.0, 4.0]);
        assert_eq!(variance_of_sample(even.iter().copied(), 2), 2.0 * 2.0);
        // The same as samples of their own: squares of −2, 0, 0, 2 over three.
        assert!((variance_of_sample(even.into_iter(), 1) - 8.0 / 3.0).abs() < 1e-12);
    }
}
