//! Counts the rays that each length costs.

use super::LENGTHS;
use std::ops::ControlFlow;
use traylib_integrators::{Bdpt, Control, Limits, Settings, ThreadError, render};
use traylib_scene::Scene;

/// Passes to count in: every path of a picture counts, so a few tell it well.
const PASSES: u32 = 2;

/// Rays that the paths of each length cost beyond those of the shorter ones.
pub(super) fn rays(scene: &Scene) -> Result<[f64; LENGTHS], ThreadError> {
    let mut rays = [0.0; LENGTHS];
    let mut before = 0.0;
    for (i, rays) in rays.iter_mut().enumerate() {
        let last = i + 1 == LENGTHS;
        let within = count(scene, (!last).then_some(i as u32 + 1))?;
        *rays = f64::max(within - before, 0.0);
        before = within;
    }
    Ok(rays)
}

fn count(scene: &Scene, max_depth: Option<u32>) -> Result<f64, ThreadError> {
    let limits = Limits { max_depth, ..Limits::default() };
    let bdpt = Bdpt { limits, ..Bdpt::default() };
    let settings = Settings { spp: PASSES, seed: 0, threads: 0, ..Settings::default() };
    let rendering =
        render(scene, &bdpt, &settings, &Control::default(), &mut |_| ControlFlow::Continue(()))?;
    Ok(rendering.statistics.rays() as f64)
}
