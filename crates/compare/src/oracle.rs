//! The instrument tested: noise and cost of one sample under a disk lamp, where
//! theory knows the noise.
//!
//! The scene is A2 of `traylib_known::analytic`, the theory
//! `traylib_known::variance`.

mod cost;
mod crossing;
#[cfg(test)]
mod tests;

use crate::results::{Estimate, Oracle, OracleCurve, OraclePoint};
use cost::Costs;
use std::panic::resume_unwind;
use traylib_known::estimators::Estimator;
use traylib_math::Heuristic;
use traylib_statistics::normal::OUTSIDE_1E_3;
use traylib_statistics::{Interval, Moments};

/// The estimators whose noise is known.
const ESTIMATORS: [Estimator; 4] = [
    Estimator::Walks,
    Estimator::LightSamples,
    Estimator::Both(Heuristic::Power),
    Estimator::Both(Heuristic::Balance),
];

/// Samples of A2 in a pass.
const SAMPLES_A_PASS: u64 = 4096;

/// The extent of a measurement.
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
    passes: 64,
    radii: &[0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.45, 2.0, 3.0, 5.0, 10.0],
    timing: (0.01, 5),
};

const QUICK: Size =
    Size { passes: 16, radii: &[0.1, 0.3, 1.0, 1.45, 3.0, 10.0], timing: (0.005, 5) };

/// Measures noise and cost of one sample of each estimator at several radii, and
/// where `puremc` and `directlight` are worth the same. Tells what it is at.
///
/// Times on one thread and measures noise on several. Takes some ten seconds in an
/// optimised build, or two in a hurry.
pub fn oracle(quick: bool, tell: &dyn Fn(&str)) -> Oracle {
    measure(&if quick { QUICK } else { FULL }, tell)
}

fn measure(size: &Size, tell: &dyn Fn(&str)) -> Oracle {
    let mut curves =
        ESTIMATORS.map(|of| OracleCurve { method: of.method().to_string(), points: vec![] });
    for (number, &radius) in size.radii.iter().enumerate() {
        tell(&format!("noise at R/h = {radius}"));
        let costs = Costs::measure(radius, &ESTIMATORS, size.timing);
        let noise: [Moments; ESTIMATORS.len()] = side_by_side(|i| {
            let seed = (number * ESTIMATORS.len() + i) as u64;
            ESTIMATORS[i].samples(radius, size.passes, seed)
        });
        for (i, estimator) in ESTIMATORS.into_iter().enumerate() {
            curves[i].points.push(OraclePoint {
                radius,
                theory: estimator.theory(radius),
                variance: variance(&noise[i]),
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
    let Interval { mean, half_width } = moments.variance_interval(OUTSIDE_1E_3);
    Estimate { value: mean, low: mean - half_width, high: mean + half_width }
}

/// `job` of 0, 1, … at the same time.
fn side_by_side<T: Send, const N: usize>(job: impl Fn(usize) -> T + Sync) -> [T; N] {
    std::thread::scope(|scope| {
        let job = &job;
        let threads: [_; N] = std::array::from_fn(|i| scope.spawn(move || job(i)));
        threads.map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })
}
