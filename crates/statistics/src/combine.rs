//! The errors of combined estimates.

use crate::normal::OUTSIDE_1E_3;
use crate::{Estimate, Sample};

/// Estimates the ratio of the means of two laws, with its 99.9 % interval by the delta method:
/// both means are of many values. `None` unless both are positive.
pub fn ratio_of_means(a: &Sample, b: &Sample) -> Option<Estimate> {
    if a.mean <= 0.0 || b.mean <= 0.0 {
        return None;
    }
    let value = a.mean / b.mean;
    let relative = a.variance_of_mean / a.mean.powi(2) + b.variance_of_mean / b.mean.powi(2);
    let half_width = OUTSIDE_1E_3 * relative.sqrt() * value;
    Some(Estimate { value, low: value - half_width, high: value + half_width })
}

/// The weight of the first of two independent estimates of the same number in their best mean,
/// which is in inverse proportion to their variances; the second has the rest. Without any
/// variance both weigh the same.
pub fn inverse_variance_weight(first: f64, second: f64) -> f64 {
    if first + second > 0.0 { second / (first + second) } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 3 ± 0.3 over 2 ± 0.1 the relative error is √(0.1² + 0.05²) = 0.1118.
    #[test]
    fn relative_errors_of_a_ratio_add_as_squares() {
        let sample = |mean, variance_of_mean| Sample { count: 100, mean, variance_of_mean };
        let ratio = ratio_of_means(&sample(3.0, 0.09), &sample(2.0, 0.01)).unwrap();
        assert_eq!(ratio.value, 1.5);
        let wanted = OUTSIDE_1E_3 * 1.5 * 0.0125_f64.sqrt();
        assert!((ratio.high - 1.5 - wanted).abs() < 1e-12 && ratio.low < 1.5);
        assert!(ratio_of_means(&sample(0.0, 0.1), &sample(2.0, 0.1)).is_none());
        assert!(ratio_of_means(&sample(2.0, 0.1), &sample(-1.0, 0.1)).is_none());
    }

    /// w²·a + (1 − w)²·b is least there.
    #[test]
    fn the_best_mean_has_the_least_variance() {
        let variance = |w: f64| w * w * 2.0 + (1.0 - w) * (1.0 - w) * 3.0;
        let best = inverse_variance_weight(2.0, 3.0);
        assert_eq!(best, 0.6);
        assert!([-0.01, 0.01].iter().all(|off| variance(best + off) > variance(best)));
        assert_eq!(inverse_variance_weight(0.0, 3.0), 1.0);
        assert_eq!(inverse_variance_weight(0.0, 0.0), 0.5);
    }
}
