//! The variance oracle: how noisy one sample must be.
//!
//! A diffuse floor under a coaxial disk of radius R at the height 1
//! ([`disk`](crate::analytic::disk)), in units of ρ·Le: the light that arrives
//! from directions with cosine c has the integrand c/π, from c₀ = 1/√(1 + R²) to
//! 1, and dω = 2π·dc. A walk chooses directions with p_b = c/π, light sampling
//! points of the disk with 1/(πR²), which is p_l = 1/(πR²c³) per steradian. A
//! sample of the one is 1 if it hits and 0 if not; of the other c/(π·p_l) = R²c⁴.

use std::f64::consts::{PI, TAU};
use traylib_math::Heuristic;

/// F, the mean of every estimator: R²/(1 + R²).
pub fn mean(radius: f64) -> f64 {
    let square = radius * radius;
    square / (1.0 + square)
}

/// The variance of one walk, which hits the lamp with probability F: F·(1 − F).
pub fn of_walks(radius: f64) -> f64 {
    let f = mean(radius);
    f * (1.0 - f)
}

/// The variance of one light sample: the mean of R⁴c⁸ over the disk is
/// ∫ R⁴c⁸·2r·dr/R² with c² = 1/(1 + r²): R²/3·(1 − (1 + R²)⁻³), less F².
pub fn of_light_samples(radius: f64) -> f64 {
    let square = radius * radius;
    square / 3.0 * (1.0 - (1.0 + square).powi(-3)) - mean(radius).powi(2)
}

/// The variance of one walk and one light sample, weighted: the two are independent, so
/// their variances add.
pub fn of_both(radius: f64, heuristic: Heuristic) -> f64 {
    let walk = |c: f64| c / PI;
    let light = |c: f64| 1.0 / (PI * radius * radius * c.powi(3));
    part(radius, heuristic, walk, light) + part(radius, heuristic, light, walk)
}

/// Variance of a technique with density `own`, weighted against `other`.
fn part(
    radius: f64,
    heuristic: Heuristic,
    own: impl Fn(f64) -> f64,
    other: impl Fn(f64) -> f64,
) -> f64 {
    let weighted = |c: f64| c / PI / (1.0 + heuristic.raise(other(c) / own(c)));
    let first = over_disk(radius, weighted);
    let second = over_disk(radius, |c| weighted(c).powi(2) / own(c));
    second - first * first
}

/// ∫ f dω over the directions to the disk, by the midpoint rule.
fn over_disk(radius: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 100_000;
    let least = 1.0 / (1.0 + radius * radius).sqrt();
    let step = (1.0 - least) / f64::from(STEPS);
    let sum: f64 = (0..STEPS).map(|i| f(least + (f64::from(i) + 0.5) * step)).sum();
    TAU * step * sum
}

/// Returns the radius R at which a walk and a light sample are equally noisy. With q = 1/(1 + R²)
/// the two second moments are equal where 1 − q³ = 3q.
pub fn crossing() -> f64 {
    let mut q: f64 = 0.3;
    for _ in 0..50 {
        q = (1.0 - q.powi(3)) / 3.0;
    }
    (1.0 / q - 1.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that quadrature and random sampling agreed on.
    #[test]
    fn variances_have_their_known_values() {
        let rows = [
            (0.1, 9.803e-3, 3.235e-9, 9.454e-7, 3.328e-9),
            (0.3, 0.07575, 1.689e-5, 4.558e-4, 1.977e-5),
            (1.0, 0.25, 0.041_667, 0.042_953, 0.032_196),
            (2.0, 0.16, 0.682_67, 0.113_99, 0.143_17),
            (3.0, 0.09, 2.187, 0.141_58, 0.162_19),
            (10.0, 9.803e-3, 32.353, 0.106_66, 0.088_48),
        ];
        for (radius, walks, lights, balance, power) in rows {
            for (found, known) in [
                (of_walks(radius), walks),
                (of_light_samples(radius), lights),
                (of_both(radius, Heuristic::Balance), balance),
                (of_both(radius, Heuristic::Power), power),
            ] {
                assert!((found / known - 1.0).abs() < 3e-4, "R = {radius}: {found} {known}");
            }
        }
    }

    #[test]
    fn the_two_are_equal_at_their_crossing() {
        let radius = crossing();
        assert!((radius - 1.450_45).abs() < 1e-5, "{radius}");
        assert!((of_walks(radius) / of_light_samples(radius) - 1.0).abs() < 1e-9);
    }
}
