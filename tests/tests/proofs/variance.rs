//! The noise of one sample against its closed form; the derivations stand in
//! `traylib_known::variance`.
//!
//! The 24 comparisons at length are a family, with one false alarm in a thousand runs:
//! seeds are fixed, but every change of what is drawn for what is another run.

use traylib_known::estimators::{Estimator, root_near};
use traylib_known::variance::crossing;
use traylib_statistics::normal::two_sided_quantile;
use traylib_statistics::{Interval, sidak};
use traylib_tests::findings::{Finding, settle};

/// The family.
const FAMILY: (f64, usize) = (1e-3, 24);

fn compare(estimator: Estimator, radius: f64, passes: u32, seed: u64) -> Finding {
    let moments = estimator.samples(radius, passes, seed);
    let theory = estimator.theory(radius);
    let level = sidak(FAMILY.0, FAMILY.1);
    let Interval { mean, half_width } = moments.variance_interval(two_sided_quantile(level));
    Finding {
        claim: format!("A2 R/h = {radius}, {estimator:?}: variance of one sample"),
        statistic: format!("{mean:.5e} ± {half_width:.1e}, theory {theory:.5e}"),
        level: Some(level),
        samples: moments.count as u64,
        holds: (mean - theory).abs() <= half_width && half_width < 0.2 * theory,
    }
}

fn all_follow_theory(radii: &[f64], passes: u32) {
    let cells = radii.iter().flat_map(|&radius| Estimator::ALL.map(|of| (radius, of)));
    let findings: Vec<Finding> = cells
        .enumerate()
        .map(|(i, (radius, of))| compare(of, radius, passes, 200 + i as u64))
        .collect();
    settle(&findings);
}

#[test]
fn noise_follows_theory() {
    all_follow_theory(&[0.3, 1.0, 3.0], 24);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn noise_follows_theory_at_length() {
    all_follow_theory(&[0.1, 0.3, 1.0, 2.0, 3.0, 10.0], 256);
}

/// The radius at which walks and light samples are equally noisy: the root of
/// the parabola through the differences at three radii around it.
fn measured_crossing(middle: f64, step: f64, passes: u32) -> f64 {
    let difference = |i: u8| {
        let (radius, seed) = (middle + (f64::from(i) - 1.0) * step, 250 + u64::from(i));
        Estimator::LightSamples.samples(radius, passes, seed).variance
            - Estimator::Walks.samples(radius, passes, seed).variance
    };
    root_near(middle, step, [0, 1, 2].map(difference))
}

fn crossing_is_where_theory_says(passes: u32, tolerance: f64) {
    let found = measured_crossing(1.45, 0.1, passes);
    let theory = crossing();
    settle(&[Finding {
        claim: "A2: puremc and directlight are equally noisy at R/h".into(),
        statistic: format!("{found:.5}, theory {theory:.5}, allowed ± {tolerance}"),
        level: None,
        samples: 6 * 4096 * u64::from(passes),
        holds: (found - theory).abs() <= tolerance,
    }]);
}

/// The standard error is about 0.001 here.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn methods_cross_where_theory_says() {
    crossing_is_where_theory_says(256, 0.01);
}
