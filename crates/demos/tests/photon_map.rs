//! The public parts of algorithms are enough: the photon map of the examples finds the light that
//! bdpt finds, the better the smaller its radius.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on says so")]
#![allow(dead_code, reason = "the example's own start is not wanted")]

#[path = "../examples/photon_map.rs"]
mod photon_map;

use traylib_integrators::{Bdpt, Integrator, Settings, render_to_end};
use traylib_io::{LoadOptions, load_scene_with};
use traylib_statistics::Sample;

/// Mean of the picture, green, of one seed.
fn mean(integrator: &dyn Integrator, seed: u64, threads: usize) -> f64 {
    let options = LoadOptions { resolution: Some((32, 24)), ..LoadOptions::default() };
    let scene = load_scene_with("cornell", options).unwrap().scene;
    let settings = Settings { spp: 16, seed, threads, ..Settings::default() };
    let film = render_to_end(&scene, integrator, &settings).unwrap().film.mean();
    let sum: f64 = film.values().iter().map(|radiance| radiance[1]).sum();
    sum / film.values().len() as f64
}

/// Mean over seeds, and its standard error.
fn estimate(integrator: &dyn Integrator) -> [f64; 2] {
    let means: Vec<f64> = (0..16).map(|seed| mean(integrator, seed, 0)).collect();
    let Sample { mean, variance_of_mean, .. } = Sample::of(&means);
    [mean, variance_of_mean.sqrt()]
}

/// Within six standard errors, which by chance fails once in 10⁴ times with so few seeds,
/// and 1 % for the radius, which is not zero yet.
#[test]
fn photons_bring_the_light_of_bidirectional_paths() {
    let [right, right_error] = estimate(&Bdpt::default());
    let [found, error] = estimate(&photon_map::mapping(0.05));
    let error = error.hypot(right_error);
    assert!((found - right).abs() < 6.0 * error + 0.01 * right, "{found} {right} {error}");
    assert!(error < 0.01 * right, "{error}");
}

#[test]
fn threads_do_not_change_photons() {
    let means = [1, 2].map(|threads| mean(&photon_map::mapping(0.1), 0, threads));
    assert_eq!(means[0].to_bits(), means[1].to_bits());
}
