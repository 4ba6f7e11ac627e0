//! Tests whether something happens as often as it should.

use crate::findings::Finding;
use crate::laws::FAMILY_LEVEL;
use traylib_statistics::binomial::two_sided;
use traylib_statistics::sidak;

/// At least as many as there are such tests in one run of the proofs.
pub const TESTS: usize = 400;

/// Quadrature leaves this much open in a probability.
const QUADRATURE: f64 = 1e-6;

/// Holds a count against the probability of what was counted, by both tails of
/// the binomial law.
pub fn happens(claim: impl Into<String>, probability: f64, count: u64, samples: u64) -> Finding {
    let level = sidak(FAMILY_LEVEL, TESTS);
    let p = two_sided(probability, QUADRATURE, count, samples);
    let frequency = count as f64 / samples as f64;
    Finding {
        claim: claim.into(),
        statistic: format!("{frequency:.6} of all, should be {probability:.6}, p = {p:.3e}"),
        level: Some(level),
        samples,
        holds: p > level,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequencies_near_their_probability_hold() {
        assert!(happens("", 0.3, 3000, 10_000).holds);
        assert!(happens("", 0.0, 0, 10_000).holds);
        assert!(happens("", 1.0, 10_000, 10_000).holds);
    }

    #[test]
    fn others_do_not() {
        // Six standard deviations of 46, to either side.
        assert!(!happens("", 0.3, 2725, 10_000).holds);
        assert!(!happens("", 0.3, 3275, 10_000).holds);
        assert!(!happens("", 0.0, 3, 10_000).holds);
        assert!(!happens("", 1.0, 9997, 10_000).holds);
    }
}
