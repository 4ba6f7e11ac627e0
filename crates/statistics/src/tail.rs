//! The index of the tail of a law: how heavy it is.

use crate::normal::OUTSIDE_5_PERCENT;

/// The number of largest values that are kept.
pub const KEPT: usize = 256;

/// The fewer of them that a second estimate is made of.
pub const FEWER: usize = 64;

/// The [`KEPT`] + 1 largest of a stream of values.
#[derive(Clone, Debug, Default)]
pub struct Largest {
    /// In any order, with at most as many again that are yet to be thrown out.
    values: Vec<f64>,
    /// Nothing below it can be among the largest.
    threshold: f64,
}

/// Hill's estimate of a tail index α, the α of P(X > x) ~ x^−α.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TailIndex {
    /// α; `None` where the largest values are all the same but for rounding, and
    /// it is infinite.
    pub alpha: Option<f64>,
    /// Upper end of its 95 % interval.
    pub upper: Option<f64>,
    /// Lower end.
    pub lower: Option<f64>,
}

impl Largest {
    /// Takes in one value; those that are not positive have no part in a tail.
    pub fn add(&mut self, value: f64) {
        if value > self.threshold {
            self.values.push(value);
            if self.values.len() == 2 * (KEPT + 1) {
                self.prune();
            }
        }
    }

    /// Returns the values that were kept, the largest first: at most [`KEPT`] + 1.
    pub fn descending(&self) -> Vec<f64> {
        let mut sorted = self.clone();
        sorted.prune();
        sorted.values
    }

    fn prune(&mut self) {
        self.values.sort_by(|a, b| b.total_cmp(a));
        self.values.truncate(KEPT + 1);
        if self.values.len() > KEPT {
            self.threshold = self.values[KEPT];
        }
    }

    /// Hill's estimate from the `k` largest; `None` if there are not more than
    /// `k` positive values, or more are asked for than were kept.
    pub fn tail_index(&self, k: usize) -> Option<TailIndex> {
        hill(&self.descending(), k)
    }
}

/// 1/α = the mean of ln(xᵢ/x₍ₖ₊₁₎) over the k largest, its relative deviation
/// 1/√k.
///
/// Hill, *A simple general approach to inference about the tail of a
/// distribution*, 1975.
fn hill(descending: &[f64], k: usize) -> Option<TailIndex> {
    let threshold = *descending.get(k)?;
    let logarithms: f64 = descending[..k].iter().map(|value| (value / threshold).ln()).sum();
    let finite = |alpha: f64| (alpha < 1e6).then_some(alpha);
    let alpha = k as f64 / logarithms;
    let relative = OUTSIDE_5_PERCENT / (k as f64).sqrt();
    Some(TailIndex {
        alpha: finite(alpha),
        upper: finite(alpha * (1.0 + relative)),
        lower: finite(alpha * (1.0 - relative)),
    })
}

/// Tells whether the law behind these two estimates has no variance: by the many values
/// its index is below two, and by the few it is not larger.
///
/// Two estimates, because one is fooled by a tail that ends. The values of a sharp
/// lobe at random angles are spread evenly in their logarithm up to their largest:
/// from far below it they look like a power law of a small index, but with a
/// quarter of the values the index is four times as large. That of a power law
/// stays, within 11 % (one deviation). To ask instead that both intervals lie below
/// two would miss an index of 1.5 three times in ten, for from 64 values it is
/// known to an eighth.
pub fn alarm(many: Option<TailIndex>, few: Option<TailIndex>) -> bool {
    let (Some(many), Some(few)) = (many, few) else { return false };
    let (Some(upper), Some(lower)) = (many.upper, few.lower) else { return false };
    upper < 2.0 && lower <= upper
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    /// Largest values e⁴, e³ … over 1: the mean logarithm is 2.5.
    #[test]
    fn hills_estimate_is_the_inverse_of_the_mean_logarithm() {
        let mut largest = Largest::default();
        (0..=4).for_each(|power| largest.add(f64::from(power).exp()));
        let TailIndex { alpha, upper, lower } = largest.tail_index(4).unwrap();
        assert!((alpha.unwrap() - 0.4).abs() < 1e-12);
        assert!(
            (upper.unwrap() - 0.4 * 1.98).abs() < 1e-12 && (lower.unwrap() - 0.008).abs() < 1e-12
        );
    }

    #[test]
    fn without_enough_values_there_is_no_index_and_no_alarm() {
        let mut largest = Largest::default();
        (0..FEWER).for_each(|i| largest.add(i as f64 + 1.0));
        assert_eq!(largest.tail_index(FEWER), None);
        largest.add(0.5);
        assert!(largest.tail_index(FEWER).is_some() && largest.tail_index(KEPT).is_none());
        assert!(!alarm(None, largest.tail_index(FEWER)));
        let mut same = Largest::default();
        (0..1000).for_each(|_| same.add(3.0));
        assert_eq!(same.tail_index(KEPT).unwrap().alpha, None);
    }

    /// The largest are the largest, in whatever order they come.
    #[test]
    fn what_is_kept_does_not_depend_on_the_order() {
        let mut sampler = Sampler::numbered(5, 3);
        let mut values: Vec<f64> =
            (0..10_000).map(|_| 1.0 / (1.0 - f64::from(sampler.next_1d()))).collect();
        let index = |values: &[f64]| {
            let mut largest = Largest::default();
            for &value in values {
                largest.add(value);
            }
            largest.tail_index(KEPT)
        };
        let found = index(&values);
        values.sort_by(f64::total_cmp);
        assert_eq!(found, index(&values));
        values.reverse();
        assert_eq!(found, index(&values));
    }
}
