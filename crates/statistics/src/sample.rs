//! The mean of independent values, and where the mean of their law lies.

use crate::student;

/// Mean and spread of independent values that follow the same law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The number of values.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Unbiased estimate of the variance of the *mean*; zero for one value.
    pub variance_of_mean: f64,
}

/// The interval in which the mean of a law lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Mean of the values.
    pub mean: f64,
    /// The distance, to either side, within which the mean of the law lies.
    pub half_width: f64,
}

impl Sample {
    /// Describes these values.
    pub fn of(values: &[f64]) -> Self {
        let count = values.len();
        let n = count as f64;
        let mean = values.iter().sum::<f64>() / n.max(1.0);
        let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        let variance_of_mean = if count < 2 { 0.0 } else { squares / ((n - 1.0) * n) };
        Self { count, mean, variance_of_mean }
    }

    /// Standard errors that the mean lies from zero; `None` where there is but one
    /// value, or all are alike.
    pub fn z_score(&self) -> Option<f64> {
        let z = self.mean / self.variance_of_mean.sqrt();
        z.is_finite().then_some(z)
    }
}

impl Interval {
    /// Tells whether `value` lies within.
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
    let quantile = student::two_sided_quantile(level, (count - 1) as f64);
    Interval { mean, half_width: quantile * variance_of_mean.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    /// Two-sided quantiles of Student's law from printed tables, one of them far
    /// out where the levels of families lie.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        // Values with mean zero and variance of the mean one.
        let values = |n: usize| {
            let unit = ((n - 1) as f64).sqrt();
            (0..n).map(|i| if i % 2 == 0 { unit } else { -unit }).collect::<Vec<_>>()
        };
        for (count, level, quantile) in [(2, 0.05, 12.706), (10, 0.01, 3.250), (32, 1e-3, 3.633)] {
            let interval = mean_interval(&values(count), level);
            assert!((interval.half_width - quantile).abs() < 1e-3, "{count}: {interval:?}");
        }
        // With one degree of freedom, Cauchy's law, it is cot(π·level/2).
        let half_width = mean_interval(&values(2), 1e-6).half_width;
        let exact = 1.0 / (std::f64::consts::FRAC_PI_2 * 1e-6).tan();
        assert!((half_width / exact - 1.0).abs() < 1e-6, "{half_width} {exact}");
        // Families of many passes: normal to the eye, 4.89164 at 1e-6.
        let half_width = mean_interval(&values(100_000), 1e-6).half_width;
        assert!((half_width - 4.892).abs() < 2e-3, "{half_width}");
    }

    #[test]
    fn one_value_says_nothing() {
        assert!(mean_interval(&[1.0], 0.01).half_width.is_infinite());
        assert_eq!(mean_interval(&[1.0; 5], 0.01), Interval { mean: 1.0, half_width: 0.0 });
    }

    #[test]
    fn the_z_score_is_the_mean_over_its_error() {
        // Variance 1, of the mean a third.
        let z = Sample::of(&[1.0, 2.0, 3.0]).z_score().unwrap();
        assert!((z - 2.0 * 3.0_f64.sqrt()).abs() < 1e-12, "{z}");
        assert_eq!(Sample::of(&[1.0, 1.0]).z_score(), None);
        assert_eq!(Sample::of(&[1.0]).z_score(), None);
        assert_eq!(Sample::of(&[0.0]).z_score(), None);
    }

    /// The interval at level 0.1 misses the mean in a tenth of 4000 trials; five
    /// standard errors of that count are 95.
    #[test]
    fn intervals_miss_as_often_as_they_say() {
        let mut sampler = Sampler::numbered(1, 0);
        let mut values = || -> Vec<f64> { (0..16).map(|_| f64::from(sampler.next_1d())).collect() };
        let missed = (0..4000).filter(|_| !mean_interval(&values(), 0.1).contains(0.5)).count();
        assert!(missed.abs_diff(400) < 95, "{missed}");
    }
}
