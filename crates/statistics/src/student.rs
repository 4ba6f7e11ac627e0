//! Student's law, for means of few normal values.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability that a value lies as far from zero as `t` or further, to either side; one
/// for degrees of freedom that make no sense.
pub fn two_sided(t: f64, freedom: f64) -> f64 {
    law(freedom).map_or(1.0, |law| 2.0 * law.sf(t))
}

/// Returns how far from zero a value lies, to either side, with probability `level` or less;
/// infinite for degrees of freedom that make no sense.
pub fn two_sided_quantile(level: f64, freedom: f64) -> f64 {
    // The lower tail, where small levels keep their digits.
    law(freedom).map_or(f64::INFINITY, |law| -law.inverse_cdf(0.5 * level))
}

fn law(freedom: f64) -> Option<StudentsT> {
    StudentsT::new(0.0, 1.0, freedom).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With one degree of freedom, Cauchy's law: P(|X| > t) = 1 − 2/π·atan t.
    #[test]
    fn one_degree_of_freedom_is_cauchys_law() {
        let exact = 1.0 - 2.0 / std::f64::consts::PI * 3.0_f64.atan();
        assert!((two_sided(3.0, 1.0) - exact).abs() < 1e-9);
        assert!((two_sided_quantile(exact, 1.0) - 3.0).abs() < 1e-6);
    }

    #[test]
    fn no_degrees_of_freedom_tell_nothing() {
        assert_eq!(two_sided(3.0, 0.0), 1.0);
        assert_eq!(two_sided_quantile(0.01, -1.0), f64::INFINITY);
    }
}
