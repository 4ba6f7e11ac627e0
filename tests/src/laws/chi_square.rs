//! Tests whether counts follow stated probabilities.

use crate::findings::Finding;
use crate::laws::FAMILY_LEVEL;
use traylib_statistics::chi_square::{Fit, fit};
use traylib_statistics::sidak;

/// At least as many as there are chi-square tests in one run of the proofs.
pub const TESTS: usize = 400;

/// [`fit`] as a finding, at the level of the family of all chi-square tests.
pub fn follows(claim: impl Into<String>, probabilities: &[f64], counts: &[u64]) -> Finding {
    let Fit { statistic, freedom, p } = fit(probabilities, counts);
    let level = sidak(FAMILY_LEVEL, TESTS);
    Finding {
        claim: claim.into(),
        statistic: format!("chi-square {statistic:.1} of {freedom} degrees, p = {p:.3e}"),
        level: Some(level),
        samples: counts.iter().sum(),
        holds: p > level,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    /// Counts of `samples` points of ten cells, where `warp` is applied to
    /// uniform numbers.
    fn counts(samples: u32, warp: impl Fn(f64) -> f64) -> Vec<u64> {
        let mut sampler = Sampler::numbered(31, 0);
        let mut counts = vec![0; 10];
        for _ in 0..samples {
            counts[(warp(f64::from(sampler.next_1d())) * 10.0) as usize] += 1;
        }
        counts
    }

    /// The cosine of a direction on the hemisphere: uniform if all directions are
    /// alike, a square root if they follow the cosine.
    #[test]
    fn a_right_density_is_accepted_and_a_wrong_one_refused() {
        let cosine: Vec<f64> = (0..10).map(|i| f64::from(2 * i + 1) / 100.0).collect();
        let uniform = [0.1; 10];
        let (even, by_cosine) = (counts(10_000, |u| u), counts(10_000, f64::sqrt));
        assert!(follows("", &uniform, &even).holds && follows("", &cosine, &by_cosine).holds);
        assert!(!follows("", &cosine, &even).holds && !follows("", &uniform, &by_cosine).holds);
    }

    /// One per cent more in half of the cells is seen at a million samples.
    #[test]
    fn a_small_slope_is_refused() {
        let tilted: Vec<f64> = (0..10).map(|i| 0.1 + if i < 5 { 5e-4 } else { -5e-4 }).collect();
        let even = counts(1_000_000, |u| u);
        assert!(follows("", &[0.1; 10], &even).holds);
        assert!(!follows("", &tilted, &even).holds);
    }
}
