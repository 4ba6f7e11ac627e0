//! The gain of means of many samples over single ones.

use crate::PointSet;

/// Passes that are rendered to tell of a picture.
#[derive(Clone, Copy)]
pub(super) struct Passes {
    /// The source of their numbers.
    pub(super) points: PointSet,
    /// The number of these passes.
    pub(super) count: u32,
    /// The number of passes of the picture.
    pub(super) spp: u32,
}

impl Passes {
    /// The variance of the mean of as many values as a picture has, times their number, of all
    /// that have these weights: `values` has those of the passes one after the other, for each
    /// weight.
    ///
    /// Quasi-random points make means better than their samples are, the more so the more there
    /// are: how the variance of means falls within the passes is carried on.
    pub(super) fn variance(self, values: &[[f64; 3]], weights: &[f64]) -> f64 {
        let Self { points, count, spp } = self;
        let mean = |groups: Groups| {
            let each = values.chunks(count as usize).zip(weights);
            let sum: f64 = each.map(|(values, weight)| weight * groups.variance(values)).sum();
            sum / weights.len() as f64
        };
        let sequences = points.sequences() as usize;
        if sequences == 1 {
            return mean(Groups { side_by_side: count as usize, of: 1 });
        }
        // Of single samples, and of means of several in a sequence.
        let in_sequence = count as usize / sequences;
        let single = mean(Groups { side_by_side: sequences, of: 1 });
        let several = mean(Groups { side_by_side: sequences, of: in_sequence });
        several * grown(several / single, in_sequence, spp as usize / sequences)
    }
}

/// Returns the factor by which the part left of a sample's variance changes from means of
/// `measured` to means of `wanted`, where `left` is left in the former: it goes on as a power.
fn grown(left: f64, measured: usize, wanted: usize) -> f64 {
    let doublings = |of: usize| (of.max(1) as f64).log2();
    let by = (left.log2() / doublings(measured)).clamp(-1.0, 0.0);
    // What is smooth enough to go on like that for long has little error anyway.
    let more = (doublings(wanted) - doublings(measured)).clamp(-doublings(measured), 4.0);
    if by.is_finite() { (by * more).exp2() } else { 1.0 }
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
