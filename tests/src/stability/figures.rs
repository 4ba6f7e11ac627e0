//! From what was kept of a cell to the figures it is judged by.

use crate::stability::cell::{Kept, RUNS};
use crate::stability::reference::Reference;
use serde::{Deserialize, Serialize};
use traylib_statistics::normal::OUTSIDE_1E_3;
use traylib_statistics::slope::{Level, Slope, fit};
use traylib_statistics::tail::{FEWER, KEPT, TailIndex};
use traylib_statistics::{Sample, mean_interval, median};

/// The chance with which an image mean's interval misses its truth.
pub const LEVEL: f64 = 1e-3;

/// The error whose price is asked.
pub const TARGET: f64 = 1e-2;

/// Slopes are fitted from 2⁴ passes on.
const FIRST_LEVEL: usize = 4;

/// The figures of a cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Passes in each run.
    pub passes: u32,
    /// Mean of the image over all runs.
    pub mean: f64,
    /// Half the width of the 99.9 % interval around it, over the runs; the noise of a rendered
    /// reference included.
    pub half_width: f64,
    /// The value that the mean should have.
    pub truth: f64,
    /// relMSE of the middle run.
    pub median_rel_mse: f64,
    /// The relMSE of the worst run.
    pub worst_rel_mse: f64,
    /// relMSE times passes, less the reference's own: of one pass.
    pub rel_mse_per_pass: f64,
    /// The time of one pass, on the machine of the run.
    pub seconds_per_pass: f64,
    /// Hill's estimate from the 256 largest pass values.
    pub tail: Option<TailIndex>,
    /// From the 64 largest.
    pub far_tail: Option<TailIndex>,
    /// Excess kurtosis of pass values, all pixels together, each in its unit.
    pub kurtosis: Option<f64>,
    /// The kurtosis over that of the first half; about 2 means without bound.
    pub kurtosis_growth: Option<f64>,
    /// Share of the largest 0.1 % of pass values in their sum of squares.
    pub energy_share: f64,
    /// Pixels off by more than max(10 σ, 0.1·mean), per megapixel, once relMSE
    /// is 10⁻², or at the end of the runs.
    pub fireflies: f64,
    /// The exponent of convergence.
    pub slope: Option<Slope>,
    /// Samples that were not sound numbers.
    pub rejected: u64,
}

impl Figures {
    /// Computes the figures of a cell.
    pub fn of(kept: &Kept, reference: &Reference) -> Self {
        let runs = 0..RUNS as usize;
        let last = kept.last_level();
        let pictures: Vec<Vec<f64>> = runs.map(|run| kept.picture(run, last)).collect();
        let means: Vec<f64> = pictures.iter().map(|p| Sample::of(p).mean).collect();
        let mut errors: Vec<f64> = pictures.iter().map(|p| reference.rel_mse(p)).collect();
        errors.sort_by(f64::total_cmp);
        let error = Sample::of(&errors).mean;
        let interval = mean_interval(&means, LEVEL);
        let reference_error = OUTSIDE_1E_3 * reference.variance_of_mean().sqrt();
        let per_pass = (error - reference.own_rel_mse()).max(0.0) * f64::from(kept.passes);
        let kurtosis = kept.all.excess_kurtosis();
        Self {
            passes: kept.passes,
            mean: interval.mean,
            half_width: interval.half_width.hypot(reference_error),
            truth: reference.mean(),
            median_rel_mse: median(errors.clone()),
            worst_rel_mse: errors[errors.len() - 1],
            rel_mse_per_pass: per_pass,
            seconds_per_pass: kept.seconds,
            tail: kept.largest.tail_index(KEPT),
            far_tail: kept.largest.tail_index(FEWER),
            kurtosis,
            kurtosis_growth: kurtosis
                .zip(kept.half.excess_kurtosis())
                .map(|(all, half)| all / half),
            energy_share: kept.energy.share_of_largest(),
            fireflies: fireflies(kept, reference, per_pass / TARGET),
            slope: fit(&levels(kept)),
            rejected: kept.rejected,
        }
    }

    /// Passes to relMSE 10⁻².
    pub fn passes_to_target(&self) -> f64 {
        self.rel_mse_per_pass / TARGET
    }

    /// Seconds to relMSE 10⁻², at least those of one pass: nothing is
    /// faster.
    pub fn seconds_to_target(&self) -> f64 {
        self.seconds_per_pass * self.passes_to_target().max(1.0)
    }
}

fn levels(kept: &Kept) -> Vec<Level> {
    let noisy: Vec<(usize, f64)> = (0..kept.squares.len())
        .map(|pixel| (pixel, kept.variance(pixel)))
        .filter(|&(_, variance)| variance > 0.0)
        .collect();
    let level = |level: usize| {
        let pictures: Vec<Vec<f64>> =
            (0..kept.runs.len()).map(|run| kept.picture(run, level)).collect();
        let variance = |&(pixel, unit): &(usize, f64)| {
            let values: Vec<f64> = pictures.iter().map(|picture| picture[pixel]).collect();
            let Sample { count, variance_of_mean, .. } = Sample::of(&values);
            variance_of_mean * count as f64 / unit
        };
        let variances = noisy.iter().map(variance).collect();
        Level { passes: f64::from(1_u32 << level), variances }
    };
    (FIRST_LEVEL..=kept.last_level()).map(level).collect()
}

/// Per megapixel, over all runs, at the first power of two of passes that is at
/// least `passes`, or the last.
fn fireflies(kept: &Kept, reference: &Reference, passes: f64) -> f64 {
    let level = (passes.max(1.0).log2().ceil() as usize).min(kept.last_level());
    let limit = 0.1 * reference.mean();
    let deviation = |pixel| (kept.variance(pixel) / f64::from(1_u32 << level)).sqrt();
    let limits: Vec<f64> =
        (0..reference.pixels.len()).map(|p| (10.0 * deviation(p)).max(limit)).collect();
    let count = |run: usize| {
        let picture = kept.picture(run, level);
        let far = |p: &usize| (picture[*p] - reference.pixels[*p]).abs() > limits[*p];
        (0..picture.len()).filter(far).count()
    };
    let found: usize = (0..kept.runs.len()).map(count).sum();
    found as f64 * 1e6 / (kept.runs.len() * reference.pixels.len()) as f64
}
