//! The noise of a method as it is, by the numbers that a picture would have.

use super::probes::{Probed, Probes};
use super::tiles::{Tiles, bands, product};
use crate::{BdptSettings, Method, PointSet};

/// Variance of one sample a pixel, relative as relMSE is, from `passes` of every probe. It is
/// that of the mean of as many samples as a picture has, times their number: quasi-random
/// points make means better than their samples are, the more so the more there are.
///
/// Samples of more than `clip` times the light around count as so many times: of what is as
/// rare among so few a forecast knows more.
pub(super) fn trial(
    probes: &Probes<'_>,
    tiles: &Tiles,
    method: Method,
    (points, passes, spp): (PointSet, u32, u32),
    clip: f64,
) -> f64 {
    let integrator = method.build();
    // Lamps that the camera sees are left out, as of the pilot: by the same rays alone.
    let seen = Method::PURE_MC.up_to(Some(1)).build();
    let seen = probes.ask(&*seen, points, passes, |_, _, probed| probed.radiance);
    let answers = probes.ask(&*integrator, points, passes, |probe, pass, probed| {
        // Splats are rare in each pixel: their variance is their mean square.
        let square = |pixel, light| tiles.weight(pixel) * product(light, light);
        let splat = |(pixel, light)| square(pixel, bands(light)).min(clip * clip);
        let Probed { radiance, splats, .. } = probed;
        let (mut rest, seen) = (bands(radiance), seen[probe * passes as usize + pass as usize]);
        rest.iter_mut().zip(bands(seen)).for_each(|(rest, seen)| *rest -= seen);
        let size = square(probes.pixels[probe], rest).sqrt();
        if size > clip {
            rest = rest.map(|band| band * clip / size);
        }
        (rest, splats.into_iter().map(splat).sum::<f64>())
    });
    // One light path was asked for each sample, whatever their number in a pass.
    let of_probes = || answers.chunks(passes as usize);
    let splats = of_probes()
        .map(|answers| answers.iter().map(|(_, squares)| squares).sum::<f64>() / f64::from(passes));
    let mean = |sum: f64| sum / probes.pixels.len() as f64;
    let splats = light_paths(method) * mean(splats.sum());
    let own = |groups: Groups| {
        let variances = of_probes().zip(&probes.pixels).map(|(answers, &pixel)| {
            let values: Vec<[f64; 3]> = answers.iter().map(|(radiance, _)| *radiance).collect();
            tiles.weight(pixel) * groups.variance(&values)
        });
        mean(variances.sum())
    };
    let sequences = points.sequences() as usize;
    if sequences == 1 {
        return splats + own(Groups { side_by_side: passes as usize, of: 1 });
    }
    // Of single samples, and of means of several in a sequence.
    let in_sequence = passes as usize / sequences;
    let single = own(Groups { side_by_side: sequences, of: 1 });
    let several = own(Groups { side_by_side: sequences, of: in_sequence });
    splats + several * grown(several / single, in_sequence, spp as usize / sequences)
}

/// What is left of a sample's variance in means of `wanted`, for each that is left in those of
/// `measured`, where `left` is left of it in these: it goes on as a power.
fn grown(left: f64, measured: usize, wanted: usize) -> f64 {
    let doublings = |of: usize| (of.max(1) as f64).log2();
    let by = (left.log2() / doublings(measured)).clamp(-1.0, 0.0);
    // What is smooth enough to go on like that for long has little error anyway.
    let more = (doublings(wanted) - doublings(measured)).clamp(-doublings(measured), 4.0);
    if by.is_finite() { (by * more).exp2() } else { 1.0 }
}

/// Light paths for each pixel of a pass.
fn light_paths(method: Method) -> f64 {
    match method {
        Method::Bdpt(BdptSettings { light_paths, .. }) => light_paths.ratio(),
        Method::Trace(_) | Method::PureMc(_) | Method::DirectLight(_) | Method::Particle(_) => 1.0,
    }
}

/// Values in the order of their passes, which belong to sequences by turns.
#[derive(Clone, Copy)]
struct Groups {
    /// Sequences.
    side_by_side: usize,
    /// Values of each that make a mean.
    of: usize,
}

impl Groups {
    /// The variance of such a mean, times the number of its values: the mean of all that can be
    /// told between sequences.
    fn variance(self, values: &[[f64; 3]]) -> f64 {
        let Self { side_by_side, of } = self;
        let sets = values.chunks_exact(side_by_side * of);
        let count = sets.len() as f64;
        let all = sets.map(|set| {
            let mean = |sequence: usize, band: usize| {
                set.iter().skip(sequence).step_by(side_by_side).map(|v| v[band]).sum::<f64>()
                    / of as f64
            };
            let n = side_by_side as f64;
            let band = |band: usize| {
                let middle = (0..side_by_side).map(|i| mean(i, band)).sum::<f64>() / n;
                let square = |i| (mean(i, band) - middle).powi(2);
                (0..side_by_side).map(square).sum::<f64>() / (n - 1.0)
            };
            of as f64 * (0..3).map(band).sum::<f64>() / 3.0
        });
        all.sum::<f64>() / count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sequences_are_the_unit() {
        let values = [0.0, 2.0, 2.0, 4.0].map(|value| [value; 3]);
        // Means 1 and 3 of two values each.
        let variance = |side_by_side, of| Groups { side_by_side, of }.variance(&values);
        assert_eq!(variance(2, 2), 2.0 * 2.0);
        // Between each two that are side by side.
        assert_eq!(variance(2, 1), 2.0);
        assert!((variance(4, 1) - 8.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn gains_go_on_as_they_began() {
        // Half of it is left in means of four: a quarter in means of sixteen.
        assert!((grown(0.5, 4, 16) - 0.5).abs() < 1e-12);
        assert!((grown(0.5, 4, 1) - 2.0).abs() < 1e-12);
        assert_eq!(grown(1.3, 4, 64), 1.0);
        assert_eq!(grown(f64::NAN, 4, 64), 1.0);
    }
}
