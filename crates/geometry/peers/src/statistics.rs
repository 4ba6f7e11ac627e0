//! Medians, and how sure one may be of them.

/// Intervals hold the true median at least this often.
const CONFIDENCE: f64 = 0.95;

/// The median of a sample and an interval for the median of what it was drawn from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Median {
    pub(crate) value: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Median {
    /// Computes the median of a sample, which is not empty.
    ///
    /// The interval is between two of the sorted values, the same number of places
    /// from either end, and supposes nothing of the distribution: each value is
    /// below the median with probability one half. For nine values it is the second
    /// and the eighth. Below six there is no such interval, and it is the range.
    pub(crate) fn of(mut sample: Vec<f64>) -> Self {
        sample.sort_by(f64::total_cmp);
        let n = sample.len();
        let place = places_cut(n);
        let value = f64::midpoint(sample[(n - 1) / 2], sample[n / 2]);
        Self { value, low: sample[place], high: sample[n - 1 - place] }
    }
}

/// Returns how many of `n` sorted values may be cut off either end.
///
/// The k-th value is above the median when fewer than k values are below it, which
/// has the probability of fewer than k heads in `n` throws.
fn places_cut(n: usize) -> usize {
    let mut exactly = 0.5_f64.powf(n as f64);
    let mut at_most = exactly;
    let mut heads = 0;
    while 2.0 * at_most <= 1.0 - CONFIDENCE {
        heads += 1;
        exactly *= (n - heads + 1) as f64 / heads as f64;
        at_most += exactly;
    }
    heads.saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the tables of the sign test: n, and the rank of the lower end.
    #[test]
    fn ranks_are_those_of_the_sign_test() {
        for (n, rank) in [(5, 1), (6, 1), (8, 1), (9, 2), (12, 3), (15, 4), (20, 6), (25, 8)] {
            assert_eq!(places_cut(n) + 1, rank, "{n} values");
        }
    }

    #[test]
    fn nine_values_in_any_order() {
        let sample = vec![9.0, 1.0, 8.0, 2.0, 7.0, 3.0, 6.0, 4.0, 5.0];
        assert_eq!(Median::of(sample), Median { value: 5.0, low: 2.0, high: 8.0 });
    }

    #[test]
    fn an_even_number_has_its_median_between_two() {
        assert_eq!(Median::of(vec![4.0, 1.0]), Median { value: 2.5, low: 1.0, high: 4.0 });
        assert_eq!(Median::of(vec![3.0]), Median { value: 3.0, low: 3.0, high: 3.0 });
    }
}
