//! Levels of many tests at once.

/// The level at which each of `tests` tests may be held for at most one false
/// alarm among them all with probability `family`: exact for independent
/// tests, and rather too strict for tests that hang together.
///
/// Šidák, *Rectangular confidence regions for the means of multivariate normal
/// distributions*, 1967.
pub fn sidak(family: f64, tests: usize) -> f64 {
    // 1 − (1 − α)^(1/m) without the cancellation.
    -((-family).ln_1p() / tests.max(1) as f64).exp_m1()
}

/// Tells which of these hypotheses are refused when a false alarm among them all may have the
/// probability `family`, however they depend on one another.
///
/// Holm, *A simple sequentially rejective multiple test procedure*, 1979.
pub fn holm(p_values: &[f64], family: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|&a, &b| p_values[a].total_cmp(&p_values[b]));
    let mut refused = vec![false; p_values.len()];
    for (rank, &index) in order.iter().enumerate() {
        if p_values[index] > family / (p_values.len() - rank) as f64 {
            break;
        }
        refused[index] = true;
    }
    refused
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_of_a_family_add_up() {
        for tests in [1, 2, 100] {
            let level = sidak(1e-3, tests);
            let family = 1.0 - (1.0 - level).powf(tests as f64);
            assert!((family - 1e-3).abs() < 1e-9, "{tests}: {family}");
        }
    }

    #[test]
    fn holm_grows_more_lenient_and_stops_at_the_first_survivor() {
        // Limits 0.0125, 0.0167, 0.025: the third fails, so the last, though small
        // enough for its own limit of 0.05, stands as well.
        assert_eq!(holm(&[0.04, 0.01, 0.016, 0.03], 0.05), [false, true, true, false]);
        assert_eq!(holm(&[], 0.05), Vec::<bool>::new());
    }
}
