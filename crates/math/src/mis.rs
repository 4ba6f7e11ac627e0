//! Multiple importance sampling.

/// The rule by which the densities of several techniques become weights
/// (Veach and Guibas 1995; the paper's equations 2 and 3, "optimal
/// combination").
///
/// With densities q₁ … qₙ (each times its number of samples) technique i has
/// weight qᵢᵇ / Σ qⱼᵇ. The weights must sum to one wherever there is light and be
/// zero wherever the technique's density is: the paper leaves both conditions
/// unsaid. Nor is the combination always better than its best member; it is
/// never much worse (Veach 1997, theorem 9.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Heuristic {
    /// Exponent b = 1.
    Balance,
    /// Exponent b = 2, better where one technique is nearly perfect.
    #[default]
    Power,
}

impl Heuristic {
    /// P(x) = xᵇ, applied to ratios of densities, whose squares may leave the
    /// range of single precision.
    #[inline]
    pub fn raise(self, ratio: f64) -> f64 {
        match self {
            Self::Balance => ratio,
            Self::Power => ratio * ratio,
        }
    }

    /// The weight of a technique with density `own` beside one with density
    /// `other`. Ratios are formed before powers, so no square can overflow.
    #[inline]
    pub fn weight(self, own: f32, other: f32) -> f32 {
        if own <= 0.0 {
            return 0.0;
        }
        (1.0 / (1.0 + self.raise(f64::from(other) / f64::from(own)))) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_weights_sum_to_one() {
        for heuristic in [Heuristic::Balance, Heuristic::Power] {
            for (a, b) in [(1.0, 3.0), (1e30, 1e-8), (0.0, 2.0)] {
                let sum = heuristic.weight(a, b) + heuristic.weight(b, a);
                assert!((sum - 1.0).abs() < 1e-6, "{heuristic:?} {a} {b}: {sum}");
            }
        }
    }

    #[test]
    fn power_prefers_the_denser_technique() {
        assert_eq!(Heuristic::Balance.weight(3.0, 1.0), 0.75);
        assert_eq!(Heuristic::Power.weight(3.0, 1.0), 0.9);
    }
}
