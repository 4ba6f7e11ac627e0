//! Renderings as numbers: pass by pass.

use std::ops::ControlFlow;
use traylib_integrators::{Control, Integrator, Settings, Statistics, render};
use traylib_math::Grid;
use traylib_scene::Scene;

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
