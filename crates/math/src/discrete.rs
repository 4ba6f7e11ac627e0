//! Choosing one of a list.

/// Chooses an index with a probability proportional to its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscreteDistribution {
    /// `cumulative[i]` is the chance of an index up to and including `i`.
    cumulative: Vec<f64>,
    probabilities: Vec<f32>,
}

impl DiscreteDistribution {
    /// A distribution over `weights.len()` indices; `None` if a weight is
    /// negative or not finite, or none is positive.
    pub fn new(weights: &[f32]) -> Option<Self> {
        Self::with_floor(weights, 0.0)
    }

    /// Builds it with every weight below `floor` times their mean raised to that. No
    /// index then is rarer than `floor`/(1 + `floor`) over their number. Weights of
    /// which none is raised give the same bits as [`new`](Self::new).
    pub fn with_floor(weights: &[f32], floor: f64) -> Option<Self> {
        let sum_of = |weights: &[f64]| weights.iter().sum::<f64>();
        let sound = weights.iter().all(|&w| w >= 0.0 && w.is_finite());
        let mut weights: Vec<f64> = weights.iter().map(|&w| f64::from(w)).collect();
        let sum = sum_of(&weights);
        if !sound || sum <= 0.0 {
            return None;
        }
        let least = floor * sum / weights.len() as f64;
        for weight in &mut weights {
            *weight = weight.max(least);
        }
        let total = sum_of(&weights);
        let mut sum = 0.0;
        let running = |&weight: &f64| {
            sum += weight;
            sum / total
        };
        let mut cumulative: Vec<f64> = weights.iter().map(running).collect();
        // Rounding must not leave a gap below one that no index owns.
        let last = weights.iter().rposition(|&w| w > 0.0)?;
        cumulative[last..].fill(1.0);
        let probabilities = weights.iter().map(|w| (w / total) as f32).collect();
        Some(Self { cumulative, probabilities })
    }

    /// The index that `u`, uniform on [0, 1), chooses, and its probability. An index
    /// that is rarer than the steps of `u` may never be chosen.
    pub fn choose(&self, u: f64) -> (usize, f32) {
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
            let (index, probability) = distribution.choose((f64::from(i) + 0.5) / 8000.0);
            assert_eq!(probability, distribution.probability(index));
            counts[index] += 1;
        }
        assert_eq!(counts, [1000, 0, 2000, 5000, 0]);
    }

    #[test]
    fn the_largest_number_below_one_finds_an_index_with_weight() {
        let distribution = DiscreteDistribution::new(&[0.1, 0.7, 0.0]).unwrap();
        assert_eq!(distribution.choose(1.0 - f64::EPSILON / 2.0).0, 1);
    }

    /// Of eight weights the mean is 2⁹⁰/8; a sixteenth of that is 2⁸³.
    #[test]
    fn a_floor_lifts_what_is_rare() {
        let mut weights = [0.0; 8];
        (weights[2], weights[5]) = (2_f32.powi(90), 1.0);
        let distribution = DiscreteDistribution::with_floor(&weights, 1.0 / 16.0).unwrap();
        let total = 128.0 + 7.0;
        for i in 0..8 {
            let known = if i == 2 { 128.0 / total } else { 1.0 / total };
            assert_eq!(distribution.probability(i), known as f32);
            let before = i as f64 + if i > 2 { 127.0 } else { 0.0 };
            assert_eq!(distribution.choose((before + 0.5) / total).0, i);
        }
    }

    #[test]
    fn a_floor_below_all_weights_leaves_every_bit() {
        let weights: Vec<f32> = (0..100_u8).map(|i| 1.0 / (f32::from(i) + 3.0)).collect();
        let plain = DiscreteDistribution::new(&weights);
        assert_eq!(DiscreteDistribution::with_floor(&weights, 1.0 / 16.0), plain);
    }

    #[test]
    fn nothing_to_choose_from_is_refused() {
        for weights in [&[][..], &[0.0], &[1.0, -1.0], &[f32::NAN]] {
            assert!(DiscreteDistribution::new(weights).is_none(), "{weights:?}");
        }
    }
}
