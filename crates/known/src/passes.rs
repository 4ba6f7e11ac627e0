//! Renderings as numbers: pass by pass.

use std::ops::ControlFlow;
use traylib_integrators::{Control, Integrator, PointSet, Settings, Statistics, render};
use traylib_math::Grid;
use traylib_scene::Scene;

/// Names the points of [`settings_by_pass`], if they are others than independent ones.
pub const SAMPLER_VARIABLE: &str = "TRAYLIB_SAMPLER";

/// For a rendering of so many passes, each of which is evidence of its own: on one thread, by
/// independent points, unless the variable [`SAMPLER_VARIABLE`] names others.
///
/// Passes of quasi-random points depend on one another so that means of many vary less than
/// they would by the spread of single ones: intervals are wider than they had to be, and false
/// alarms are rarer.
///
/// # Panics
/// If the variable names no points.
pub fn settings_by_pass(passes: u32, seed: u64) -> Settings {
    let named = std::env::var(SAMPLER_VARIABLE).ok().map(|name| {
        name.parse().unwrap_or_else(|wanted| panic!("{SAMPLER_VARIABLE}={name}: {wanted}"))
    });
    let points = named.unwrap_or(PointSet::Independent);
    Settings { spp: passes, seed, threads: 1, points }
}

/// Renders and hands every pass, on its own, to `observe`.
///
/// # Panics
/// If the system refuses a thread.
pub fn each_pass(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
    mut observe: impl FnMut(Grid<[f64; 3]>),
) -> Statistics {
    let mut before: Option<Grid<[f64; 3]>> = None;
    let rendering = render(scene, integrator, settings, &Control::default(), &mut |progress| {
        let passes = f64::from(progress.film.passes());
        let total = progress.film.mean().map(|mean| mean.map(|band| band * passes));
        let mut pass = total.clone();
        if let Some(before) = before.replace(total) {
            for (pass, before) in pass.values_mut().iter_mut().zip(before.values()) {
                for (pass, before) in pass.iter_mut().zip(before) {
                    *pass -= before;
                }
            }
        }
        observe(pass);
        ControlFlow::Continue(())
    });
    rendering.expect("one thread or two").statistics
}

/// The mean of the green band over the film, for each pass.
pub fn pass_means(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
) -> (Vec<f64>, Statistics) {
    let mut means = Vec::new();
    let statistics = each_pass(scene, integrator, settings, |pass| {
        let sum: f64 = pass.values().iter().map(|bands| bands[1]).sum();
        means.push(sum / pass.values().len() as f64);
    });
    (means, statistics)
}

/// Camera samples, of which there are as many as light paths.
pub fn samples_in_a_pass(scene: &Scene) -> u64 {
    u64::from(scene.camera().width()) * u64::from(scene.camera().height())
}
