//! Limits on the length of paths, and Russian roulette.

use traylib_math::Rgb;

/// Bounds on the length of paths, counted in edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// The longest path; `None` lets roulette end paths. One edge is a lamp seen
    /// directly, two are direct light. A limit loses the light of longer paths.
    pub max_depth: Option<u32>,
    /// The Russian roulette that may end paths.
    pub roulette: Roulette,
}

impl Limits {
    /// No longest path, and roulette where it usually begins: the default.
    pub const NONE: Self = Self { max_depth: None, roulette: Roulette::DEFAULT };
    /// No longest path, and roulette where it begins for camera walks alone.
    pub const OF_CAMERA_WALKS: Self = Self { max_depth: None, roulette: Roulette::OF_CAMERA_WALKS };

    /// Tells whether a path of this many edges may be rendered.
    pub fn allow(&self, edges: u32) -> bool {
        self.max_depth.is_none_or(|max| edges <= max)
    }
}

/// Russian roulette: a path survives with a chance as large as the part of the
/// light that the last surface kept, and counts for the more.
///
/// Where no light is lost, in a white room or in light that glass holds, that alone
/// would never end. So a walk goes on beyond 256 edges with a chance below one whatever
/// its surfaces keep; see `longest_chance`.
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
        Self::DEFAULT
    }
}

/// A path that still carries light must be able to survive.
const SMALLEST_CHANCE: f32 = 0.05;

impl Roulette {
    /// From the third edge on: direct light is always found.
    pub const DEFAULT: Self = Self { from_edge: 3 };
    /// From the fourth edge on, of walks from the camera that are joined with no others: what
    /// they find by an edge more, nobody else does. See `docs/sampling.md` for what it buys.
    pub const OF_CAMERA_WALKS: Self = Self { from_edge: 4 };
    /// No roulette: paths end at a length limit, or never.
    pub const OFF: Self = Self { from_edge: u32::MAX };

    /// Returns the divisor of a walk's throughput if it survives to this edge, where the last
    /// vertex gave `weight`; `None` if it ends.
    pub fn survive(self, edge: u32, weight: Rgb, u: f32) -> Option<f32> {
        if edge < self.from_edge {
            return Some(1.0);
        }
        // By the band that kept most: no band is ended that carries light.
        let chance = weight.max_band().clamp(SMALLEST_CHANCE, longest_chance(edge));
        (u < chance).then_some(chance)
    }
}

/// Walks up to this edge may go on for certain.
const LONG: u32 = 256;

/// Walks beyond this edge end the sooner.
const VERY_LONG: u32 = 4096;

/// The largest chance to survive to an edge.
///
/// With 1 − p/n at edge n, (m/n)ᵖ of the walks with m edges get n. They count for
/// (n/m)ᵖ, which grows more slowly than any power of an albedo a below one falls: the
/// variance stays finite, as it would not with any constant chance below a². Albedos up
/// to 0.99 are left as they are; at 0.999 walks have 695 edges on average instead of
/// 1000 and twice the variance, and 1100 where nothing is lost. Beyond 4096 edges p is
/// 6: of a thousand million walks the longest has some 80,000 edges.
fn longest_chance(edge: u32) -> f32 {
    let power = if edge <= VERY_LONG { 1.0 } else { 6.0 };
    if edge <= LONG { 1.0 } else { 1.0 - power / edge as f32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn survivors_make_up_for_the_rest() {
        let roulette = Roulette::default();
        let edge = roulette.from_edge;
        for weight in [0.0, 0.3, 0.9, 1.5] {
            let n = 10_000;
            let mean: f32 = (0..n)
                .filter_map(|i| roulette.survive(edge, Rgb::splat(weight), i as f32 / n as f32))
                .map(|chance| 1.0 / chance)
                .sum::<f32>()
                / n as f32;
            assert!((mean - 1.0).abs() < 1e-3, "{weight}: {mean}");
        }
    }

    /// Where nothing is lost, walks have 1100 edges or so.
    #[test]
    fn walks_that_lose_nothing_end() {
        let roulette = Roulette::default();
        let mut alive = 1.0_f64;
        let mut edges = 0.0;
        for edge in 2..1_000_000 {
            let chance = f64::from(longest_chance(edge));
            assert_eq!(roulette.survive(edge, Rgb::WHITE, 0.0), Some(chance as f32));
            alive *= chance;
            edges += alive;
        }
        assert!((1000.0..1200.0).contains(&edges), "{edges}");
        assert!(alive < 1e-14, "{alive}");
    }

    #[test]
    fn early_edges_are_safe() {
        let last = 1.0 - f32::EPSILON;
        for roulette in [Roulette::DEFAULT, Roulette::OF_CAMERA_WALKS] {
            let edge = roulette.from_edge;
            assert_eq!(roulette.survive(edge - 1, Rgb::BLACK, last), Some(1.0));
            assert_eq!(roulette.survive(edge, Rgb::BLACK, last), None);
        }
        assert_eq!(Roulette::OFF.survive(1000, Rgb::BLACK, last), Some(1.0));
    }

    #[test]
    fn a_limit_counts_edges() {
        let limits = Limits { max_depth: Some(2), ..Limits::default() };
        assert!(limits.allow(2) && !limits.allow(3));
        assert!(Limits::default().allow(1_000_000));
    }
}
