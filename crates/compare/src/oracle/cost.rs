//! Measures the cost of one sample.

use super::SAMPLES_A_PASS;
use traylib_integrators::Integrator;
use traylib_known::analytic::disk;
use traylib_known::cost::interleaved;
use traylib_known::estimators::Estimator;
use traylib_statistics::median;

/// Seconds of one sample of several estimators, each timed as often, in turns.
#[derive(Debug)]
pub(super) struct Costs(Vec<Vec<f64>>);

impl Costs {
    /// At one radius; `timing` is the seconds of each timing and how many there are.
    pub(super) fn measure(
        radius: f64,
        estimators: &[Estimator],
        (span, repetitions): (f64, usize),
    ) -> Self {
        let integrators: Vec<_> = estimators.iter().map(|of| of.method().build()).collect();
        let integrators: Vec<&dyn Integrator> = integrators.iter().map(AsRef::as_ref).collect();
        let mut times = interleaved(&disk(radius).scene, &integrators, span, repetitions);
        for time in times.iter_mut().flatten() {
            *time /= SAMPLES_A_PASS as f64;
        }
        Self(times)
    }

    /// Seconds of one sample: the median.
    pub(super) fn seconds(&self, estimator: usize) -> f64 {
        median(self.0[estimator].clone())
    }

    /// Logarithm of the cost of the first estimator over that of the second, median
    /// of all turns; and its standard error.
    pub(super) fn log_ratio(&self) -> (f64, f64) {
        let turns = self.0[0].iter().zip(&self.0[1]);
        let logs: Vec<f64> = turns.map(|(first, second)| (first / second).ln()).collect();
        let middle = median(logs.clone());
        // The median absolute deviation of a normal law is 0.6745 σ, and the error of a
        // median is √(π/2) times that of a mean. Other programs' work makes outliers.
        let spread = median(logs.iter().map(|log| (log - middle).abs()).collect()) / 0.6745;
        (middle, spread * (std::f64::consts::FRAC_PI_2 / logs.len() as f64).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outlier_does_not_move_the_ratio() {
        let first = vec![2.0, 2.2, 1.8, 50.0, 2.0];
        let (middle, error) = Costs(vec![first, vec![1.0; 5]]).log_ratio();
        assert!((middle - 2.0_f64.ln()).abs() < 1e-12, "{middle}");
        // Deviations 0, 0, ln 1.1, −ln 0.9 and much: the one in the middle is ln 1.1.
        let expected = 1.1_f64.ln() / 0.6745 * (std::f64::consts::FRAC_PI_2 / 5.0).sqrt();
        assert!((error - expected).abs() < 1e-12, "{error}");
    }
}
