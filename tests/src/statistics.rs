//! Intervals and tests with stated error rates.
//!
//! The unit of evidence is the pass: passes are independent of one another,
//! samples within a pass are not, once light paths splat. Everything here takes
//! one number a pass, or the means of batches of passes.

use statrs::distribution::{ContinuousCDF, StudentsT};
use traylib_math::Grid;

/// Mean and spread of independent values that follow the same law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// How many values there are.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Unbiased estimate of the variance of the *mean*; zero for one value.
    pub variance_of_mean: f64,
}

/// Where the mean of a law lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Mean of the values.
    pub mean: f64,
    /// How far the law's mean may lie from it, to either side.
    pub half_width: f64,
}

/// The moments of single samples that all follow the same law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// How many samples there are.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Mean square deviation from it.
    pub variance: f64,
    /// Mean fourth power of the deviation.
    pub fourth: f64,
}

impl Moments {
    /// Of these samples.
    pub fn of(samples: &[f64]) -> Self {
        let average = |f: &dyn Fn(f64) -> f64| {
            samples.iter().map(|&x| f(x)).sum::<f64>() / samples.len().max(1) as f64
        };
        let mean = average(&|x| x);
        let variance = average(&|x| (x - mean).powi(2));
        let fourth = average(&|x| (x - mean).powi(4));
        Self { count: samples.len(), mean, variance, fourth }
    }

    /// Where the law's variance lies: its estimate is nearly normal for many
    /// samples of a bounded law, with variance (μ₄ − σ⁴)/n. That is nothing for a
    /// fair coin, so the error of the mean's place is added, which is of second
    /// order. `quantile` is that of the normal law.
    pub fn variance_interval(&self, quantile: f64) -> Interval {
        let spread = (self.fourth - self.variance * self.variance).max(0.0);
        let error = (spread / self.count as f64).sqrt();
        let of_mean = quantile * quantile * self.variance / self.count as f64;
        Interval { mean: self.variance, half_width: quantile * error + of_mean }
    }
}

impl Sample {
    /// Of these values.
    pub fn of(values: &[f64]) -> Self {
        let count = values.len();
        let n = count as f64;
        let mean = values.iter().sum::<f64>() / n.max(1.0);
        let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        let variance_of_mean = if count < 2 { 0.0 } else { squares / ((n - 1.0) * n) };
        Self { count, mean, variance_of_mean }
    }
}

impl Interval {
    /// Whether `value` lies within.
    pub fn contains(&self, value: f64) -> bool {
        (value - self.mean).abs() <= self.half_width
    }
}

/// Student's interval for the mean of the law behind `values`: misses it with
/// probability `level` if the values are normal, which means of many samples
/// nearly are. Infinitely wide for fewer than two values.
pub fn mean_interval(values: &[f64], level: f64) -> Interval {
    let Sample { count, mean, variance_of_mean } = Sample::of(values);
    if count < 2 {
        return Interval { mean, half_width: f64::INFINITY };
    }
    let quantile = student((count - 1) as f64).map_or(f64::INFINITY, |t| {
        // The lower tail, where small levels keep their digits.
        -t.inverse_cdf(0.5 * level)
    });
    Interval { mean, half_width: quantile * variance_of_mean.sqrt() }
}

/// The means of `batches` runs of equally many neighbouring values; what does
/// not fill a batch is left out.
///
/// # Panics
/// If there are fewer values than batches, or no batches.
pub fn batch_means(values: &[f64], batches: usize) -> Vec<f64> {
    assert!(batches > 0 && values.len() >= batches, "{} values", values.len());
    let size = values.len() / batches;
    let mean = |batch: &[f64]| batch.iter().sum::<f64>() / size as f64;
    values.chunks_exact(size).take(batches).map(mean).collect()
}

/// Probability that two samples of laws with the same mean differ by as much as
/// these or more, whatever the two variances: Welch's test, both sides.
///
/// Two constants are the same with probability one, or cannot be.
///
/// Welch, *The generalization of 'Student's' problem when several different
/// population variances are involved*, 1947; degrees of freedom by
/// Satterthwaite, 1946.
pub fn welch(a: &Sample, b: &Sample) -> f64 {
    let variance = a.variance_of_mean + b.variance_of_mean;
    let difference = (a.mean - b.mean).abs();
    if variance <= 0.0 {
        return if difference == 0.0 { 1.0 } else { 0.0 };
    }
    let part = |sample: &Sample| {
        let share = sample.variance_of_mean / variance;
        if share > 0.0 { share * share / (sample.count as f64 - 1.0) } else { 0.0 }
    };
    let freedom = 1.0 / (part(a) + part(b));
    student(freedom).map_or(1.0, |t| 2.0 * t.sf(difference / variance.sqrt()))
}

/// The level at which each of `tests` tests may be held for at most one false
/// alarm among them all with probability `family`: exact for independent
/// tests, and rather too strict for tests that hang together.
///
/// Šidák, *Rectangular confidence regions for the means of multivariate normal
/// distributions*, 1967.
pub fn sidak(family: f64, tests: usize) -> f64 {
    // 1 − (1 − α)^(1/m) without the cancellation.
    -((-family).ln_1p() / tests.max(1) as f64).exp_m1()
}

/// Which of these hypotheses are refused when a false alarm among them all may
/// have the probability `family`, however they depend on one another.
///
/// Holm, *A simple sequentially rejective multiple test procedure*, 1979.
pub fn holm(p_values: &[f64], family: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|&a, &b| p_values[a].total_cmp(&p_values[b]));
    let mut refused = vec![false; p_values.len()];
    for (rank, &index) in order.iter().enumerate() {
        if p_values[index] > family / (p_values.len() - rank) as f64 {
            break;
        }
        refused[index] = true;
    }
    refused
}

/// Probability that values drawn evenly from [0, 1] are spread as unevenly as
/// these or more, by the greatest distance between the two distributions.
///
/// Kolmogorov's limit with the correction of Stephens, *EDF statistics for
/// goodness of fit and some comparisons*, 1974, good from about five values on.
pub fn uniformity(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let distance = sorted
        .iter()
        .enumerate()
        .map(|(i, value)| (value - i as f64 / n).max((i + 1) as f64 / n - value))
        .fold(0.0, f64::max);
    let x = distance * (n.sqrt() + 0.12 + 0.11 / n.sqrt());
    let term = |k: i32| {
        let k = f64::from(k);
        let sign = if k % 2.0 == 0.0 { -2.0 } else { 2.0 };
        sign * (-2.0 * k * k * x * x).exp()
    };
    (1..=100).map(term).sum::<f64>().clamp(0.0, 1.0)
}

/// Means over square tiles of `side` pixels, row by row; the last tile of a row
/// or column may be smaller.
///
/// # Panics
/// If `side` is zero.
pub fn tile_means(image: &Grid<f64>, side: usize) -> Vec<f64> {
    let (columns, rows) = (image.width().div_ceil(side), image.height().div_ceil(side));
    let mut sums = vec![(0.0, 0.0); columns * rows];
    for (i, value) in image.values().iter().enumerate() {
        let (x, y) = (i % image.width(), i / image.width());
        let (sum, count) = &mut sums[y / side * columns + x / side];
        *sum += value;
        *count += 1.0;
    }
    sums.into_iter().map(|(sum, count)| sum / count).collect()
}

/// Student's law; `None` for degrees of freedom that make no sense.
fn student(freedom: f64) -> Option<StudentsT> {
    StudentsT::new(0.0, 1.0, freedom).ok()
}

#[cfg(test)]
mod tests;
