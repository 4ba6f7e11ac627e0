//! The layers beside the light that a job wants: first surfaces, and the noise of its picture.

use crate::aov::Aov;
use crate::done::Done;
use crate::job::Job;
use crate::outcome::Failure;
use std::collections::BTreeMap;
use traylib_integrators::{FirstHits, Settings, render_to_end};
use traylib_io::PictureLayer;
use traylib_math::{Grid, Rgb};

/// Enough that edges are smooth.
const MOST_PASSES: u32 = 64;

/// Makes the layers that a job wants, each once.
///
/// # Errors
/// The system refuses threads.
pub(crate) fn aov_layers(job: &Job<'_>, done: &Done) -> Result<Vec<PictureLayer>, Failure> {
    let options = job.options;
    let mut wanted = options.aov.clone();
    wanted.sort_unstable();
    wanted.dedup();
    let looks_at_scene = wanted.iter().any(|aov| aov.first_hit().is_some());
    let mut first = if looks_at_scene {
        let spp = done.passes.min(MOST_PASSES);
        let (seed, threads, points) = (options.seed, options.threads, options.sampler);
        let settings = Settings { spp, seed, threads, points };
        let seen = render_to_end(&done.loaded.scene, &FirstHits, &settings);
        seen.map_err(Failure::output)?.film.develop_layers()
    } else {
        BTreeMap::new()
    };
    let camera = done.loaded.scene.camera();
    let (width, height) = (camera.width() as usize, camera.height() as usize);
    let black = || Grid::filled(width, height, Rgb::BLACK);
    let layer = |aov: Aov| {
        let values = match aov.first_hit() {
            Some(kind) => first.remove(&kind.layer()),
            None => done.variance.clone(),
        };
        let values = values.unwrap_or_else(black);
        PictureLayer { name: aov.name(), channels: aov.channels(), values }
    };
    Ok(wanted.into_iter().map(layer).collect())
}
