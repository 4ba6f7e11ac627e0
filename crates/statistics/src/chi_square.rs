//! Tests whether counts follow stated probabilities.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Below this expectation a cell's count is too far from normal; such cells are
/// taken together.
const SPARSE: f64 = 5.0;

/// Pearson's statistic of some counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Σ (observed − expected)² / expected.
    pub statistic: f64,
    /// Cells that are left after the sparse ones were taken together, less one.
    pub freedom: usize,
    /// The chance of a statistic as large.
    pub p: f64,
}

/// Holds counts against the probabilities of their cells. Cells with an
/// expectation below five are taken together, and with the smallest other one
/// if that is not enough.
///
/// # Panics
/// Unless the probabilities are as many as the counts and sum to one within
/// 10⁻⁴: cells must leave nothing out. If fewer than two cells are left, for
/// then nothing is tested.
pub fn fit(probabilities: &[f64], counts: &[u64]) -> Fit {
    assert_eq!(probabilities.len(), counts.len());
    let sum: f64 = probabilities.iter().sum();
    assert!((sum - 1.0).abs() < 1e-4, "probabilities sum to {sum}");
    let samples: u64 = counts.iter().sum();
    let cells = pooled(probabilities.iter().map(|p| p * samples as f64).zip(counts));
    assert!(cells.len() > 1, "{} cells", cells.len());
    let statistic = cells.iter().map(|&(expected, count)| distance(expected, count)).sum();
    let freedom = cells.len() - 1;
    let law = ChiSquared::new(freedom as f64).expect("positive");
    Fit { statistic, freedom, p: law.sf(statistic) }
}

/// The cell's part of the statistic; what is impossible and was seen is
/// infinitely far.
fn distance(expected: f64, count: f64) -> f64 {
    if count == expected { 0.0 } else { (count - expected).powi(2) / expected.max(0.0) }
}

/// Cells with enough in them, as pairs of expectation and count.
fn pooled<'a>(cells: impl Iterator<Item = (f64, &'a u64)>) -> Vec<(f64, f64)> {
    let cells: Vec<(f64, f64)> = cells.map(|(expected, &count)| (expected, count as f64)).collect();
    let together = |of: &[(f64, f64)]| {
        of.iter().fold((0.0, 0.0), |sum, cell| (sum.0 + cell.0, sum.1 + cell.1))
    };
    let (sparse, mut full): (Vec<_>, Vec<_>) =
        cells.into_iter().partition(|&(expected, _)| expected < SPARSE);
    full.sort_by(|a, b| b.0.total_cmp(&a.0));
    let rest = together(&sparse);
    if rest.0 >= SPARSE {
        full.push(rest);
    } else if rest != (0.0, 0.0) {
        // Also where nothing is expected and something was seen.
        let smallest = full.pop().unwrap_or_default();
        full.push(if rest.0 == 0.0 { (0.0, f64::INFINITY) } else { together(&[smallest, rest]) });
    }
    full
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_statistic_is_pearsons() {
        let fit = fit(&[0.25, 0.75], &[30, 70]);
        assert_eq!(fit.statistic, 25.0 / 25.0 + 25.0 / 75.0);
        assert_eq!(fit.freedom, 1);
        // 2·(1 − Φ(√(4/3))).
        assert!((fit.p - 0.248_213).abs() < 1e-6, "{}", fit.p);
    }

    #[test]
    fn sparse_cells_are_taken_together() {
        // Expectations 0.5, 4.5, 45, 50: the first two make one cell of five.
        assert_eq!(fit(&[0.005, 0.045, 0.45, 0.5], &[0, 5, 45, 50]).freedom, 2);
        // Expectations 1, 49, 50: the first joins the second.
        assert_eq!(fit(&[0.01, 0.49, 0.5], &[1, 49, 50]).freedom, 1);
    }

    #[test]
    fn the_impossible_is_refused() {
        assert_eq!(fit(&[0.0, 0.5, 0.5], &[1, 500, 500]).p, 0.0);
        assert_eq!(fit(&[0.0, 0.5, 0.5], &[0, 500, 500]).p, 1.0);
    }

    #[test]
    #[should_panic(expected = "sum to 0.9")]
    fn cells_that_leave_something_out_are_a_mistake() {
        fit(&[0.5, 0.4], &[5, 5]);
    }
}
