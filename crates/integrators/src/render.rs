//! A whole rendering: threads, and pass after pass. The only place that starts threads.

mod renderer;

pub use renderer::Renderer;

use crate::{Control, Integrator, PointSet, Statistics};
pub use rayon::ThreadPool;
use std::ops::ControlFlow;
use traylib_scene::{Film, Scene};

/// The settings of a rendering, whatever the algorithm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// Passes, each with one sample a pixel.
    pub spp: u32,
    /// The same seed gives the same picture.
    pub seed: u64,
    /// Threads; 0 for one a processor. Does not change the picture.
    pub threads: usize,
    /// The source of the paths' numbers.
    pub points: PointSet,
}

/// The progress that the driver reports after each pass.
#[derive(Debug)]
pub struct Progress<'a> {
    /// All light so far.
    pub film: &'a Film,
    /// Counters so far.
    pub statistics: Statistics,
    /// Passes asked for.
    pub spp: u32,
}

/// The result of a rendering.
#[derive(Debug)]
pub struct Rendering {
    /// The picture, and further ones that the integrator was asked for.
    pub film: Film,
    /// Text that the integrator was asked for.
    pub notes: Vec<String>,
    /// Counters of the work.
    pub statistics: Statistics,
}

/// The threads could not be started.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ThreadError(String);

impl std::fmt::Display for ThreadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "cannot start threads: {}; ask for fewer with --threads", self.0)
    }
}

impl std::error::Error for ThreadError {}

/// Renders `settings.spp` passes, or fewer if `observe`, called after each pass,
/// says stop or `control` is cancelled. Then the pass under way is given up and leaves
/// no trace; if that is the first one, the film has no pass.
///
/// The result depends on scene, integrator, seed and number of passes, and on
/// nothing else: every path has random numbers of its own, and chunks are
/// summed in their order.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn render(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
    control: &Control,
    observe: &mut dyn FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<Rendering, ThreadError> {
    let pool = thread_pool(settings.threads)?;
    let mut renderer = Renderer::new(scene, integrator, settings.seed, settings.points);
    for pass in 0..settings.spp {
        // A pass that was given up leaves no trace.
        if !pool.install(|| renderer.render_pass(pass, control)) {
            break;
        }
        let Rendering { film, statistics, .. } = renderer.rendering();
        let progress = Progress { film, statistics: *statistics, spp: settings.spp };
        if observe(&progress).is_break() {
            break;
        }
    }
    Ok(renderer.finish())
}

/// Makes threads to render on, so many as asked for; 0 is one a processor.
///
/// # Errors
/// [`ThreadError`] if the system refuses them.
pub fn thread_pool(threads: usize) -> Result<ThreadPool, ThreadError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|error| ThreadError(error.to_string()))
}

/// [`render`] with nobody to watch it or to stop it.
///
/// # Errors
/// As `render`.
pub fn render_to_end(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
) -> Result<Rendering, ThreadError> {
    render(scene, integrator, settings, &Control::default(), &mut |_| ControlFlow::Continue(()))
}

#[cfg(test)]
mod tests;
