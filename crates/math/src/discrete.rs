//! Choosing one of a list.

/// Chooses an index with a probability proportional to its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscreteDistribution {
    /// `cumulative[i]` is the chance of an index up to and including `i`.
    cumulative: Vec<f32>,
    probabilities: Vec<f32>,
}

impl DiscreteDistribution {
    /// A distribution over `weights.len()` indices; `None` if a weight is
    /// negative or not finite, or none is positive.
    pub fn new(weights: &[f32]) -> Option<Self> {
        let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
        let sound = weights.iter().all(|&w| w >= 0.0 && w.is_finite());
        if !sound || total <= 0.0 {
            return None;
        }
        let mut sum = 0.0;
        let mut cumulative: Vec<f32> = weights
            .iter()
            .map(|&w| {
                sum += f64::from(w);
                (sum / total) as f32
            })
            .collect();
        // Rounding must not leave a gap below one that no index owns.
        let last = weights.iter().rposition(|&w| w > 0.0)?;
        cumulative[last..].fill(1.0);
        let probabilities = weights.iter().map(|&w| (f64::from(w) / total) as f32).collect();
        Some(Self { cumulative, probabilities })
    }

    /// The index that `u`, uniform on [0, 1), chooses, and its probability.
    pub fn choose(&self, u: f32) -> (usize, f32) {
        let index = self.cumulative.partition_point(|&c| c <= u);
        (index, self.probabilities[index])
    }

    /// The probability of an index.
    pub fn probability(&self, index: usize) -> f32 {
        self.probabilities[index]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequencies_follow_the_weights() {
        let weights = [1.0, 0.0, 2.0, 5.0, 0.0];
        let distribution = DiscreteDistribution::new(&weights).unwrap();
        let mut counts = [0; 5];
        for i in 0..8000 {
            let (index, probability) = distribution.choose((i as f32 + 0.5) / 8000.0);
            assert_eq!(probability, distribution.probability(index));
            counts[index] += 1;
        }
        assert_eq!(counts, [1000, 0, 2000, 5000, 0]);
    }

    #[test]
    fn the_largest_number_below_one_finds_an_index_with_weight() {
        let distribution = DiscreteDistribution::new(&[0.1, 0.7, 0.0]).unwrap();
        assert_eq!(distribution.choose(1.0 - f32::EPSILON / 2.0).0, 1);
    }

    #[test]
    fn nothing_to_choose_from_is_refused() {
        for weights in [&[][..], &[0.0], &[1.0, -1.0], &[f32::NAN]] {
            assert!(DiscreteDistribution::new(weights).is_none(), "{weights:?}");
        }
    }
}
