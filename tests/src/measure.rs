//! Tests whether a known radiance is among those that the passes of a rendering leave possible.

use crate::findings::{Finding, settle};
use traylib_integrators::{Method, PointSet, Settings, Statistics};
use traylib_known::{Case, pass_means, samples_in_a_pass, settings_by_pass};
use traylib_statistics::{Interval, mean_interval, sidak};

/// The chance with which the comparisons with known radiances, all of them together, raise a false
/// alarm.
pub const FAMILY_LEVEL: f64 = 1e-3;

/// At least as many as there are comparisons with known radiances in the whole
/// package. More widens every interval and makes false alarms rarer.
pub const FAMILY_SIZE: usize = 400;

/// The widest interval, on either side and relative to the truth, that counts
/// as evidence: agreement within an interval as wide as the picture is bright
/// would say nothing.
pub const EQUIVALENCE: f64 = 5e-3;

/// The error that single precision, the extent of a spot and truncated integrals may add, relative
/// to the truth. Decides alone where an estimator has no variance.
const ROUNDING: f64 = 2e-5;

/// Compares a method with the truth: every sample sound, the truth within the
/// interval of the family's level, and the interval narrow. The number of passes
/// and the seed are the caller's, fixed beforehand.
pub fn compare(case: &Case, method: Method, passes: u32, seed: u64) -> Finding {
    compare_within(case, method, passes, seed, EQUIVALENCE)
}

/// Compares where the interval may be as wide as `equivalence` to either side,
/// relative to the truth.
pub fn compare_within(
    case: &Case,
    method: Method,
    passes: u32,
    seed: u64,
    equivalence: f64,
) -> Finding {
    let settings = settings_by_pass(passes, seed);
    let claim = format!("{}, {method}: mean radiance", case.name);
    judge(claim, &measure(case, method, &settings), case.truth, equivalence)
}

/// Compares a method with the truth by quasi-random points. Their passes depend on one another
/// so that means of many vary less than they would by the spread of single ones: the interval
/// is wider than it had to be, and false alarms are rarer.
pub fn compare_by_points(case: &Case, method: Method, passes: u32, seed: u64) -> Finding {
    let points = PointSet::Sobol;
    let settings = Settings { spp: passes, seed, threads: 1, points };
    let claim = format!("{}, {method} --sampler {points}: mean radiance", case.name);
    judge(claim, &measure(case, method, &settings), case.truth, EQUIVALENCE)
}

fn measure(case: &Case, method: Method, settings: &Settings) -> Measured {
    let integrator = method.up_to(case.max_depth).build();
    let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), settings);
    let samples = u64::from(settings.spp) * samples_in_a_pass(&case.scene);
    Measured { means, statistics, samples }
}

/// The outcome of a rendering.
#[derive(Debug)]
pub struct Measured {
    /// A number for each pass.
    pub means: Vec<f64>,
    /// Rays and samples that it took.
    pub statistics: Statistics,
    /// Samples behind all means together.
    pub samples: u64,
}

/// Holds the mean of all passes against the truth, as [`compare`] does; the
/// interval may be as wide as `equivalence` to either side, relative to the
/// truth.
pub fn judge(claim: String, measured: &Measured, truth: f64, equivalence: f64) -> Finding {
    let level = sidak(FAMILY_LEVEL, FAMILY_SIZE);
    let Interval { mean, half_width } = mean_interval(&measured.means, level);
    let wide = Interval { mean, half_width: half_width + ROUNDING * truth };
    let rejected = measured.statistics.rejected;
    let complaint = if rejected > 0 {
        format!(", {rejected} samples were not sound numbers")
    } else if !wide.contains(truth) {
        String::from(", the truth is not within")
    } else if half_width > equivalence * truth {
        String::from(", too wide to say anything")
    } else {
        String::new()
    };
    Finding {
        claim,
        statistic: if truth < 1e-3 {
            format!("{mean:.5e} ± {half_width:.1e}, truth {truth:.5e}{complaint}")
        } else {
            format!("{mean:.6} ± {half_width:.6}, truth {truth:.6}{complaint}")
        },
        level: Some(level),
        samples: measured.samples,
        holds: complaint.is_empty(),
    }
}

/// [`compare`] for each of these methods, with its number of passes.
///
/// # Panics
/// With everything that did not hold.
pub fn all_hold(case: &Case, seed: u64, methods: &[(Method, u32)]) {
    let findings: Vec<Finding> =
        methods.iter().map(|&(method, passes)| compare(case, method, passes, seed)).collect();
    settle(&findings);
}
