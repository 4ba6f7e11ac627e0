//! How long paths get.

use traylib_math::Rgb;

/// Bounds on the length of paths, counted in edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// The longest path; `None` lets roulette end paths. One edge is a lamp seen
    /// directly, two are direct light. A limit loses the light of longer paths.
    pub max_depth: Option<u32>,
    /// Where paths may end by chance.
    pub roulette: Roulette,
}

impl Limits {
    /// Whether a path of this many edges may be rendered.
    pub fn allow(&self, edges: u32) -> bool {
        self.max_depth.is_none_or(|max| edges <= max)
    }
}

/// Russian roulette: a path survives with a chance as large as the part of the
/// light that the last surface kept, and counts for the more.
///
/// The chance scales the estimator alone. It enters no density and no weight,
/// so it may depend on whatever it likes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Roulette {
    /// The first edge of a walk that roulette may prevent.
    pub from_edge: u32,
}

impl Default for Roulette {
    fn default() -> Self {
        Self { from_edge: 3 }
    }
}

/// A path that still carries light must be able to survive.
const SMALLEST_CHANCE: f32 = 0.05;

impl Roulette {
    /// No roulette: paths end at a length limit, or never.
    pub const OFF: Self = Self { from_edge: u32::MAX };

    /// What a walk's throughput is divided by if it survives to this edge, where
    /// the last vertex gave `weight`; `None` if it ends.
    pub fn survive(self, edge: u32, weight: Rgb, u: f32) -> Option<f32> {
        if edge < self.from_edge {
            return Some(1.0);
        }
        let chance = weight.max_band().clamp(SMALLEST_CHANCE, 1.0);
        (u < chance).then_some(chance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn survivors_make_up_for_the_rest() {
        let roulette = Roulette::default();
        for weight in [0.0, 0.3, 0.9, 1.5] {
            let n = 10_000;
            let mean: f32 = (0..n)
                .filter_map(|i| roulette.survive(3, Rgb::splat(weight), i as f32 / n as f32))
                .map(|chance| 1.0 / chance)
                .sum::<f32>()
                / n as f32;
            assert!((mean - 1.0).abs() < 1e-3, "{weight}: {mean}");
        }
    }

    #[test]
    fn early_edges_are_safe() {
        let last = 1.0 - f32::EPSILON;
        assert_eq!(Roulette::default().survive(2, Rgb::BLACK, last), Some(1.0));
        assert_eq!(Roulette::default().survive(3, Rgb::BLACK, last), None);
        assert_eq!(Roulette::OFF.survive(1000, Rgb::BLACK, last), Some(1.0));
    }

    #[test]
    fn a_limit_counts_edges() {
        let limits = Limits { max_depth: Some(2), ..Limits::default() };
        assert!(limits.allow(2) && !limits.allow(3));
        assert!(Limits::default().allow(1_000_000));
    }
}
