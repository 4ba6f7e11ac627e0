//! Whether something happens as often as it should.

use crate::laws::FAMILY_LEVEL;
use crate::ledger::Finding;
use crate::statistics::sidak;
use statrs::distribution::{Binomial, DiscreteCDF};

/// At least as many as there are such tests in one run of the proofs.
pub const TESTS: usize = 400;

/// Quadrature leaves this much open in a probability.
const QUADRATURE: f64 = 1e-6;

/// Holds a count against the probability of what was counted, by both tails of
/// the binomial law.
pub fn happens(claim: impl Into<String>, probability: f64, count: u64, samples: u64) -> Finding {
    let level = sidak(FAMILY_LEVEL, TESTS);
    let p = tails(probability, count, samples);
    let frequency = count as f64 / samples as f64;
    Finding {
        claim: claim.into(),
        statistic: format!("{frequency:.6} of all, should be {probability:.6}, p = {p:.3e}"),
        level: Some(level),
        samples,
        holds: p > level,
    }
}

/// Twice the smaller tail, seen from the most favourable probability that
/// quadrature leaves open.
fn tails(probability: f64, count: u64, samples: u64) -> f64 {
    let law = |p: f64| Binomial::new(p.clamp(0.0, 1.0), samples).expect("a probability");
    let below = law(probability - QUADRATURE).cdf(count);
    let above = count.checked_sub(1).map_or(1.0, |less| law(probability + QUADRATURE).sf(less));
    (2.0 * below.min(above)).min(1.0)
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
