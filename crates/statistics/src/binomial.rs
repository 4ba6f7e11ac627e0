//! Tests whether something happens as often as it should.

use statrs::distribution::{Binomial, DiscreteCDF};

/// Twice the smaller tail of the binomial law of `samples` trials, one at most: the
/// chance of a count as far out as `count`. The probability of what was counted is known
/// but for `slack` to either side; the most favourable is taken. Zero for a probability
/// that is not a number.
pub fn two_sided(probability: f64, slack: f64, count: u64, samples: u64) -> f64 {
    let law = |p: f64| Binomial::new(p.clamp(0.0, 1.0), samples).ok();
    let (Some(less), Some(more)) = (law(probability - slack), law(probability + slack)) else {
        return 0.0;
    };
    let below = less.cdf(count);
    let above = count.checked_sub(1).map_or(1.0, |fewer| more.sf(fewer));
    (2.0 * below.min(above)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of ten throws of a fair coin one or none shows heads in 11 of 1024 cases.
    #[test]
    fn tails_are_those_of_pascals_triangle() {
        let exact = 2.0 * 11.0 / 1024.0;
        for count in [1, 9] {
            assert!((two_sided(0.5, 0.0, count, 10) - exact).abs() < 1e-9, "{count}");
        }
        assert_eq!(two_sided(0.5, 0.0, 5, 10), 1.0);
    }

    #[test]
    fn what_is_certain_or_impossible_is_so() {
        assert_eq!([two_sided(0.0, 0.0, 0, 9), two_sided(1.0, 0.0, 9, 9)], [1.0; 2]);
        assert_eq!([two_sided(0.0, 0.0, 1, 9), two_sided(1.0, 0.0, 8, 9)], [0.0; 2]);
        assert_eq!(two_sided(f64::NAN, 0.0, 1, 9), 0.0);
    }

    #[test]
    fn slack_leaves_the_most_favourable_probability() {
        let (sharp, wide) = (two_sided(0.3, 0.0, 350, 1000), two_sided(0.3, 0.05, 350, 1000));
        assert!(sharp < 1e-3 && wide > 0.5, "{sharp} {wide}");
    }
}
