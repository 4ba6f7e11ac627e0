//! Tests whether two means are the same.

use crate::sample::Sample;
use crate::student;

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
    student::two_sided(difference / variance.sqrt(), freedom)
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    /// At level 0.1, a tenth of 4000 trials with unequal variances and counts; five
    /// standard errors of that number are 95.
    #[test]
    fn welch_raises_false_alarms_as_often_as_it_says() {
        let mut sampler = Sampler::numbered(2, 0);
        let mut sample = |count: usize, width: f64| {
            let values: Vec<f64> =
                (0..count).map(|_| width * (f64::from(sampler.next_1d()) - 0.5)).collect();
            Sample::of(&values)
        };
        let alarms = (0..4000).filter(|_| welch(&sample(12, 1.0), &sample(40, 5.0)) < 0.1).count();
        assert!(alarms.abs_diff(400) < 95, "{alarms}");
    }

    /// Computed by hand: means 2 and 4, variances of the mean 1/3 and 4/3, so that
    /// t = 2/√(5/3) = 1.5492 with (5/3)²/(1/18 + 16/18) = 2.9412 degrees of
    /// freedom, whose two-sided tail is 0.2209 (quadrature of the density).
    #[test]
    fn welch_is_the_textbook_formula() {
        let a = Sample::of(&[1.0, 2.0, 3.0]);
        let b = Sample::of(&[2.0, 4.0, 6.0]);
        let exact = tail_by_quadrature(2.0 / (5.0_f64 / 3.0).sqrt(), 25.0 / 8.5);
        assert!((welch(&a, &b) - exact).abs() < 1e-6, "{} {exact}", welch(&a, &b));
        assert_eq!(welch(&a, &a), 1.0);
        let constant = Sample::of(&[1.0, 1.0]);
        assert_eq!(welch(&constant, &constant), 1.0);
        assert_eq!(welch(&constant, &Sample::of(&[2.0, 2.0])), 0.0);
    }

    /// Both tails of Student's density (1 + x²/ν)^(−(ν+1)/2), by the midpoint rule
    /// after x = √ν·tan a, which makes it cos^(ν−1) a.
    fn tail_by_quadrature(t: f64, freedom: f64) -> f64 {
        let integral = |from: f64| {
            let steps = 200_000;
            let width = (std::f64::consts::FRAC_PI_2 - from) / f64::from(steps);
            let height = |i: i32| (from + (f64::from(i) + 0.5) * width).cos().powf(freedom - 1.0);
            (0..steps).map(height).sum::<f64>() * width
        };
        integral((t / freedom.sqrt()).atan()) / integral(0.0)
    }
}
