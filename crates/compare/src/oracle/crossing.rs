//! The radii at which walks and light samples are worth the same.
//!
//! With V for the variance of one sample and c for its seconds, both are equal
//! where ln(V_l/V_w) = ln(c_w/c_l), and equally noisy where that is zero. The left
//! side grows with the radius and is nearly straight.

use super::cost::Costs;
use super::{Size, side_by_side};
use crate::results::{Estimate, OracleCrossing};
use traylib_known::estimators::{Estimator, root_near};
use traylib_known::variance;
use traylib_statistics::Moments;
use traylib_statistics::normal::OUTSIDE_5_PERCENT;

/// Radii are this part of the middle one apart.
const STEP: f64 = 0.07;

/// Times the passes of a point of a curve: a root is read more closely than a chart.
const PASSES_FACTOR: u32 = 2;

/// A number with its standard error.
#[derive(Clone, Copy, Debug)]
struct Measured {
    value: f64,
    error: f64,
}

/// Equally noisy, and the same variance times seconds.
pub(super) fn both(size: &Size) -> (OracleCrossing, OracleCrossing) {
    let sharp = Measured { value: 0.0, error: 0.0 };
    let ratio = cost_ratio(size);
    (crossing(size, sharp, 1000), crossing(size, ratio, 2000))
}

/// ln(c_w/c_l), near both crossings.
fn cost_ratio(size: &Size) -> Measured {
    let estimators = [Estimator::Walks, Estimator::LightSamples];
    let (span, repetitions) = size.timing;
    let costs = Costs::measure(variance::crossing(), &estimators, (span, 4 * repetitions));
    let (value, error) = costs.log_ratio();
    Measured { value, error }
}

/// Measures the radius at which ln(V_l/V_w) has this value.
fn crossing(size: &Size, target: Measured, seed: u64) -> OracleCrossing {
    let theory = radius_of(target.value);
    let step = STEP * theory;
    let ratios = side_by_side(|i| {
        let radius = theory + (i as f64 - 1.0) * step;
        log_ratio(radius, PASSES_FACTOR * size.passes, seed + 2 * i as u64)
    });
    OracleCrossing { measured: root(theory, step, target, ratios), theory }
}

/// The measured ln(V_l/V_w).
fn log_ratio(radius: f64, passes: u32, seed: u64) -> Measured {
    let lights = log_variance(&Estimator::LightSamples.samples(radius, passes, seed));
    let walks = log_variance(&Estimator::Walks.samples(radius, passes, seed + 1));
    Measured { value: lights.value - walks.value, error: lights.error.hypot(walks.error) }
}

/// ln V.
fn log_variance(moments: &Moments) -> Measured {
    let error = moments.error_of_variance() / moments.variance;
    Measured { value: moments.variance.ln(), error }
}

/// Returns the radius at which the parabola through the ratios meets the target. Its error is what
/// the errors of the four numbers move it by, which are independent.
fn root(middle: f64, step: f64, target: Measured, ratios: [Measured; 3]) -> Estimate {
    let values = ratios.map(|ratio| ratio.value);
    let at = |target: f64, values: [f64; 3]| root_near(middle, step, values.map(|v| v - target));
    let value = at(target.value, values);
    let moved_by = |i: usize| {
        let mut values = values;
        values[i] += ratios[i].error;
        at(target.value, values) - value
    };
    let by_target = at(target.value + target.error, values) - value;
    let error = [moved_by(0), moved_by(1), moved_by(2), by_target];
    let width = OUTSIDE_5_PERCENT * error.iter().map(|e| e * e).sum::<f64>().sqrt();
    Estimate { value, low: value - width, high: value + width }
}

/// Returns the radius at which ln(V_l/V_w) has this value in theory, by halving.
fn radius_of(log_ratio: f64) -> f64 {
    let (mut low, mut high) = (1e-2_f64, 1e2_f64);
    for _ in 0..60 {
        let middle = (low * high).sqrt();
        let ratio = variance::of_light_samples(middle) / variance::of_walks(middle);
        *(if ratio.ln() < log_ratio { &mut low } else { &mut high }) = middle;
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn theory_is_inverted() {
        assert!((radius_of(0.0) - variance::crossing()).abs() < 1e-9);
        let ratio = variance::of_light_samples(1.2) / variance::of_walks(1.2);
        assert!((radius_of(ratio.ln()) - 1.2).abs() < 1e-9);
    }

    #[test]
    fn errors_of_ratios_and_target_move_the_root() {
        let exact = |value| Measured { value, error: 0.0 };
        let line = [-0.2, 0.0, 0.2];
        let sharp = root(1.5, 0.1, exact(0.1), line.map(exact));
        assert!((sharp.value - 1.55).abs() < 1e-12 && sharp.low == sharp.high, "{sharp:?}");
        // The line has slope 2, so an error of 0.02 is one of 0.01 in the radius.
        let target = Measured { value: 0.0, error: 0.02 };
        let found = root(1.5, 0.1, target, line.map(exact));
        assert!((found.high - found.value - 1.96 * 0.01).abs() < 1e-9, "{found:?}");
        let values = line.map(|value| Measured { value, error: 0.02 });
        // At the middle, only the ratio there counts in first order.
        let found = root(1.5, 0.1, exact(0.0), values);
        assert!((found.high - found.value - 1.96 * 0.01).abs() < 2e-4, "{found:?}");
    }
}
