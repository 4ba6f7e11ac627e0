//! Comparisons of numbers as findings.

use crate::findings::Finding;
use crate::laws::FAMILY_LEVEL;
use traylib_statistics::{Interval, mean_interval, sidak};

/// At least as many as there are known means in the laws' tests.
pub const MEANS: usize = 600;

/// The largest error found must be within what rounding explains; NaN never is.
pub fn within(claim: impl Into<String>, worst: f64, bound: f64, samples: u64) -> Finding {
    Finding {
        claim: claim.into(),
        statistic: format!("off by at most {worst:.3e}, allowed {bound:.1e}"),
        level: None,
        samples,
        holds: worst <= bound,
    }
}

/// The larger of two errors, and not a number once either is not.
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}

/// Bits that must agree, `different` of which do not.
pub fn same_bits(claim: impl Into<String>, different: usize, of: usize) -> Finding {
    Finding {
        claim: claim.into(),
        statistic: format!("{different} of {of} differ"),
        level: None,
        samples: 0,
        holds: different == 0 && of > 0,
    }
}

/// The known value that a mean of many samples is held against.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// The mean of the law.
    pub truth: f64,
    /// The error that rounding and quadrature may add.
    pub slack: f64,
    /// The widest interval, to either side, that says something.
    pub widest: f64,
}

/// The mean of the law behind `values`, independent and nearly normal, is the
/// known one; `samples` are behind them all.
pub fn has_mean(claim: impl Into<String>, values: &[f64], known: Known, samples: u64) -> Finding {
    let level = sidak(FAMILY_LEVEL, MEANS);
    let Interval { mean, half_width } = mean_interval(values, level);
    let Known { truth, slack, widest } = known;
    let wide = Interval { mean, half_width: half_width + slack };
    Finding {
        claim: claim.into(),
        statistic: format!("{mean:.6} ± {half_width:.6}, truth {truth:.6}, widest {widest:.1e}"),
        level: Some(level),
        samples,
        holds: wide.contains(truth) && half_width <= widest,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_never_within() {
        assert!(within("", 1e-6, 1e-5, 1).holds);
        assert!(!within("", 1e-4, 1e-5, 1).holds);
        assert!(!within("", f64::NAN, 1e-5, 1).holds);
    }

    #[test]
    fn nan_stays_the_worst() {
        assert_eq!(worse(1.0, 2.0), 2.0);
        assert!(worse(worse(1.0, f64::NAN), 2.0).is_nan());
    }

    #[test]
    fn no_bits_are_no_evidence() {
        assert!(same_bits("", 0, 1).holds);
        assert!(!same_bits("", 1, 9).holds && !same_bits("", 0, 0).holds);
    }

    #[test]
    fn a_mean_must_be_near_and_known_well() {
        let values: Vec<f64> = (0..100).map(|i| 1.0 + 0.01 * f64::from(i % 5 - 2)).collect();
        let known = Known { truth: 1.0, slack: 0.0, widest: 0.01 };
        assert!(has_mean("", &values, known, 100).holds);
        assert!(!has_mean("", &values, Known { truth: 1.01, ..known }, 100).holds);
        assert!(!has_mean("", &values, Known { widest: 1e-3, ..known }, 100).holds);
    }
}
