//! The first four moments of samples, and where the variance of their law lies.

use crate::sample::Interval;

/// The moments of single samples that all follow the same law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// The number of samples.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Mean square deviation from it.
    pub variance: f64,
    /// Mean fourth power of the deviation.
    pub fourth: f64,
}

impl Moments {
    /// Computes the moments of these samples.
    pub fn of(samples: &[f64]) -> Self {
        let average = |f: &dyn Fn(f64) -> f64| {
            samples.iter().map(|&x| f(x)).sum::<f64>() / samples.len().max(1) as f64
        };
        let mean = average(&|x| x);
        let variance = average(&|x| (x - mean).powi(2));
        let fourth = average(&|x| (x - mean).powi(4));
        Self { count: samples.len(), mean, variance, fourth }
    }

    /// Standard error of the variance, for many samples: √((μ₄ − σ⁴)/n).
    pub fn error_of_variance(&self) -> f64 {
        let spread = (self.fourth - self.variance * self.variance).max(0.0);
        (spread / self.count as f64).sqrt()
    }

    /// Returns an interval for the law's variance: its estimate is nearly normal for many samples
    /// of a bounded law, with variance (μ₄ − σ⁴)/n. That is nothing for a fair coin, so the error
    /// of the mean's place is added, which is of second order. `quantile` is that of the normal
    /// law.
    pub fn variance_interval(&self, quantile: f64) -> Interval {
        let of_mean = quantile * quantile * self.variance / self.count as f64;
        Interval { mean: self.variance, half_width: quantile * self.error_of_variance() + of_mean }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A die has mean 3.5, variance 35/12, fourth moment 14.7292.
    #[test]
    fn moments_of_a_die() {
        let die = Moments::of(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!((die.count, die.mean), (6, 3.5));
        let fourth = 2.0 * (2.5_f64.powi(4) + 1.5_f64.powi(4) + 0.5_f64.powi(4)) / 6.0;
        assert!((die.variance - 35.0 / 12.0).abs() < 1e-12 && (die.fourth - fourth).abs() < 1e-12);
        let error = ((fourth - (35.0_f64 / 12.0).powi(2)) / 6.0).sqrt();
        assert!((die.error_of_variance() - error).abs() < 1e-12);
    }

    /// A fair coin's squared deviation is always a quarter: only the place of the mean is left.
    #[test]
    fn a_fair_coin_leaves_the_error_of_the_mean() {
        let coin = Moments::of(&[0.0, 1.0, 0.0, 1.0]);
        assert_eq!(coin.variance_interval(2.0), Interval { mean: 0.25, half_width: 0.25 });
    }
}
