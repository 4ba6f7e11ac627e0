//! The instrument tested: noise and cost of one sample under a disk lamp, where
//! theory knows the noise.
//!
//! The scene is A2 of `traylib_tests::known::analytic`, the theory
//! `traylib_tests::known::variance`.

mod cost;
mod crossing;
#[cfg(test)]
mod tests;

use crate::results::{Estimate, Oracle, OracleCurve, OraclePoint};
use cost::Costs;
use traylib_math::Heuristic;
use traylib_tests::known::estimators::Estimator;
use traylib_tests::statistics::{Interval, Moments};

/// The estimators, by the names of the methods.
const METHODS: [(&str, Estimator); 4] = [
    ("puremc", Estimator::Walks),
    ("directlight", Estimator::LightSamples),
    ("combined", Estimator::Both(Heuristic::Power)),
    ("combined:balance", Estimator::Both(Heuristic::Balance)),
];

/// Two sides of the normal law, 0.1 % outside.
const QUANTILE: f64 = 3.2905;

/// Samples of A2 in a pass.
const SAMPLES_A_PASS: u64 = 4096;

/// How much to measure.
#[derive(Clone, Copy, Debug)]
struct Size {
    /// Passes behind each point, of 4096 samples each.
    passes: u32,
    /// R/h, ascending.
    radii: &'static [f64],
    /// Seconds of each timing, and timings of each method at each radius.
    timing: (f64, usize),
}

const FULL: Size = Size {
    passes: 128,
    radii: &[0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.45, 2.0, 3.0, 5.0, 10.0],
    timing: (0.01, 5),
};

const QUICK: Size =
    Size { passes: 32, radii: &[0.1, 0.3, 1.0, 1.45, 3.0, 10.0], timing: (0.005, 5) };

/// Measures noise and cost of one sample of each estimator at several radii, and
/// where `puremc` and `directlight` are worth the same. Tells what it is at.
///
/// Takes one thread and, in an optimised build, some ten seconds, or three of them
/// in a hurry.
pub fn oracle(quick: bool, tell: &dyn Fn(&str)) -> Oracle {
    measure(&if quick { QUICK } else { FULL }, tell)
}

fn measure(size: &Size, tell: &dyn Fn(&str)) -> Oracle {
    let mut curves = METHODS.map(|(name, _)| OracleCurve { method: name.into(), points: vec![] });
    for (number, &radius) in size.radii.iter().enumerate() {
        tell(&format!("noise at R/h = {radius}"));
        let costs = Costs::measure(radius, &METHODS.map(|(_, of)| of), size.timing);
        for (i, (_, estimator)) in METHODS.into_iter().enumerate() {
            let seed = (number * METHODS.len() + i) as u64;
            let moments = estimator.samples(radius, size.passes, seed);
            curves[i].points.push(OraclePoint {
                radius,
                theory: estimator.theory(radius),
                variance: variance(&moments),
                seconds: costs.seconds(i),
            });
        }
    }
    tell("where puremc and directlight are worth the same");
    let (crossing, crossing_in_time) = crossing::both(size);
    let samples = u64::from(size.passes) * SAMPLES_A_PASS;
    Oracle { curves: curves.into(), crossing, crossing_in_time, samples }
}

fn variance(moments: &Moments) -> Estimate {
    let Interval { mean, half_width } = moments.variance_interval(QUANTILE);
    Estimate { value: mean, low: mean - half_width, high: mean + half_width }
}
