//! Quantiles of the normal law: standard errors from the mean, to either side.

use statrs::distribution::{ContinuousCDF, Normal};

/// 5 % lie further out.
pub const OUTSIDE_5_PERCENT: f64 = 1.96;

/// One in a thousand lies further out.
pub const OUTSIDE_1E_3: f64 = 3.2905;

/// Returns how many standard errors from the mean, to either side, a value lies with probability
/// `level` or less.
pub fn two_sided_quantile(level: f64) -> f64 {
    // The lower tail, where small levels keep their digits.
    -Normal::standard().inverse_cdf(0.5 * level)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed tables: 2.5758 at 1 %, 4.89164 at 1e-6.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        let rows =
            [(0.05, OUTSIDE_5_PERCENT), (1e-3, OUTSIDE_1E_3), (0.01, 2.5758), (1e-6, 4.89164)];
        for (level, known) in rows {
            let found = two_sided_quantile(level);
            assert!((found - known).abs() < 5e-5, "{level}: {found}");
        }
    }
}
