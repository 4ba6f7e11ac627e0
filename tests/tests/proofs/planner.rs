//! The forecasts of plans, against closed forms.

use traylib_integrators::planner::forecasts;
use traylib_integrators::{BdptSettings, Method, PathsPerPixel};
use traylib_known::analytic::disk;
use traylib_known::estimators::Estimator;
use traylib_known::furnace::{diffuse_walls, glowing_ball};
use traylib_known::variance::mean;
use traylib_math::Heuristic;
use traylib_tests::measure::all_hold;

/// Radii of the lamp over its height.
const RADII: [f64; 6] = [0.1, 0.3, 1.0, 2.0, 3.0, 10.0];

/// Pixels of which each is asked twice: 1024 samples.
const PROBES: u32 = 512;

/// The costs of light samples where a walk costs 1.
const COSTS: [f64; 3] = [1.0, 2.0, 4.0];

/// A walk and a light sample, or both.
fn cost(estimator: Estimator, light_sample: f64) -> f64 {
    match estimator {
        Estimator::Walks => 1.0,
        Estimator::LightSamples => light_sample,
        Estimator::Both(_) => 1.0 + light_sample,
    }
}

/// The estimator of the least variance times cost.
fn best(variances: [f64; 4], light_sample: f64) -> Estimator {
    let efficiency = |i: &usize| variances[*i] * cost(Estimator::ALL[*i], light_sample);
    let first = (0..4).min_by(|a, b| efficiency(a).total_cmp(&efficiency(b)));
    Estimator::ALL[first.unwrap()]
}

/// From 1024 samples of bidirectional tracing the optimum is known of techniques that were not
/// rendered by, at every radius and price. Fixed seeds; where two estimators are within 2 %
/// of each other a right program may take either, and here it does not.
#[test]
fn a_pilot_picks_the_optimum_under_a_disk() {
    for (number, radius) in RADII.into_iter().enumerate() {
        let scene = disk(radius).scene;
        let methods = Estimator::ALL.map(Estimator::method);
        let foreseen = forecasts(&scene, &methods, PROBES, number as u64).unwrap();
        let foreseen = [0, 1, 2, 3].map(|i| foreseen[i]);
        let theory = Estimator::ALL.map(|of| of.theory(radius));
        for light_sample in COSTS {
            let (picked, optimum) = (best(foreseen, light_sample), best(theory, light_sample));
            let price = |of: Estimator| of.theory(radius) * cost(of, light_sample);
            let regret = price(picked) / price(optimum);
            assert!(regret < 1.0 + 1e-9, "R/h {radius}, {light_sample}: {picked:?} {regret}");
        }
    }
}

/// The forecast is the variance itself, over the square of the mean and a hundredth of it. It is
/// a moment less a square, each of which 8192 samples tell to a thousandth or better: here to
/// less than six of these standard errors, beside 12 % of the variance, at 24 places.
#[test]
fn forecasts_are_variances() {
    for (number, radius) in RADII.into_iter().enumerate() {
        let methods = Estimator::ALL.map(Estimator::method);
        let foreseen = forecasts(&disk(radius).scene, &methods, 4096, number as u64).unwrap();
        for (estimator, foreseen) in Estimator::ALL.into_iter().zip(foreseen) {
            // Less than a thousandth of the second moment is not told from nothing.
            let (square, variance) = (mean(radius).powi(2), estimator.theory(radius));
            let moment = (variance + square) / (1.01 * square);
            let theory = (variance / (1.01 * square)).max(1e-3 * moment);
            let slack = 0.12 * theory + 4e-3 * moment;
            let is_close = (foreseen - theory).abs() < slack;
            assert!(is_close, "{radius} {estimator:?}: {foreseen} {theory} {slack}");
        }
    }
}

/// Each part of bidirectional tracing that a plan may choose finds all light: without splats,
/// without connections, with fewer light paths than pixels and with more.
#[test]
fn parts_of_bdpt_find_all_light() {
    let settings = |no_connections, no_splats, thousandths, heuristic| {
        let light_paths = PathsPerPixel::of_thousandths(thousandths);
        Method::Bdpt(BdptSettings {
            heuristic,
            no_connections,
            no_splats,
            light_paths,
            ..BdptSettings::DEFAULT
        })
    };
    let methods = [
        (settings(false, true, 1000, Heuristic::Power), 128),
        (settings(false, true, 500, Heuristic::Balance), 128),
        (settings(true, false, 250, Heuristic::Power), 256),
        (settings(false, false, 250, Heuristic::Power), 192),
        (settings(false, false, 2000, Heuristic::Balance), 128),
    ];
    all_hold(&glowing_ball(diffuse_walls(), None), 131, &methods);
}
