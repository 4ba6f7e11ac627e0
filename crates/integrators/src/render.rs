//! The driver: passes, threads, the film. The only place that starts threads.

use crate::{Chunk, ChunkOutput, Control, Integrator, Pass, Statistics};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};
use traylib_math::{Defect, planted};
use traylib_scene::{Film, PassImage, Scene};

/// Pixels in a chunk. Part of the result: sums are formed chunk by chunk.
const CHUNK_PIXELS: u32 = 256;

/// How to render, whatever the algorithm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// Passes, each with one sample a pixel.
    pub spp: u32,
    /// The same seed gives the same picture.
    pub seed: u64,
    /// Threads; 0 for one a processor. Does not change the picture.
    pub threads: usize,
}

/// What the driver tells after each pass.
#[derive(Debug)]
pub struct Progress<'a> {
    /// All light so far.
    pub film: &'a Film,
    /// Tally so far.
    pub statistics: Statistics,
    /// Passes asked for.
    pub spp: u32,
}

/// What came of it.
#[derive(Debug)]
pub struct Rendering {
    /// The picture.
    pub film: Film,
    /// Further pictures that the integrator was asked for, by number; sums over
    /// all passes.
    pub layers: BTreeMap<u16, PassImage>,
    /// Text that the integrator was asked for.
    pub notes: Vec<String>,
    /// Tally of the work.
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
    // Threads of its own, so that the number asked for is kept.
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(settings.threads)
        .build()
        .map_err(|error| ThreadError(error.to_string()))?;
    let (width, height) = (scene.camera().width(), scene.camera().height());
    let mut rendering = Rendering {
        film: Film::new(width, height),
        layers: BTreeMap::new(),
        notes: Vec::new(),
        statistics: Statistics::default(),
    };
    let pixels = width * height;
    let light_paths = integrator.light_paths(pixels);
    for pass in 0..settings.spp {
        let whole = Chunk {
            seed: settings.seed,
            pass: pass.into(),
            pixels: 0..pixels,
            light_paths: 0..light_paths,
            control,
        };
        // All chunks, by any thread in any order.
        let outputs = pool.install(|| render_pass(scene, integrator, &whole));
        // A pass that was given up leaves no trace.
        let Some(outputs) = outputs else { break };
        // Sums are formed in the order of the chunks.
        rendering.add_pass(outputs, width, height);
        let progress =
            Progress { film: &rendering.film, statistics: rendering.statistics, spp: settings.spp };
        if observe(&progress).is_break() {
            break;
        }
    }
    Ok(rendering)
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

/// What the chunks of a pass add to it, in their order; `None` if it was given up. The
/// light work that comes before them is told with the first.
fn render_pass(
    scene: &Scene,
    integrator: &dyn Integrator,
    whole: &Chunk<'_>,
) -> Option<Vec<ChunkOutput>> {
    let (chunks, control) = (chunks(whole), whole.control);
    // Whoever waits can see how far it is.
    control.begin_pass(chunks.len());
    // Light work that all chunks share comes first.
    let pass = Pass::new(scene, &chunks);
    let with_memory = integrator.begin_pass(scene, &pass);
    let light_work = pass.into_statistics();
    let render_chunk = |chunk: &Chunk<'_>| {
        let mut out = ChunkOutput::default();
        // From what the light work left, or from the chunk alone.
        match &with_memory {
            _ if control.is_cancelled() => {}
            Some(render_chunk) => render_chunk(chunk, &mut out),
            None => integrator.render_chunk(scene, chunk, &mut out),
        }
        // What was cancelled on its way may lack anything.
        if control.is_cancelled() {
            return None;
        }
        control.end_chunk();
        Some(out)
    };
    let mut outputs: Vec<ChunkOutput> =
        chunks.par_iter().map(render_chunk).collect::<Option<_>>()?;
    if let Some(first) = outputs.first_mut() {
        first.statistics += light_work;
    }
    Some(outputs)
}

/// Cuts a pass into chunks, its light paths in proportion to its pixels.
fn chunks<'a>(whole: &Chunk<'a>) -> Vec<Chunk<'a>> {
    let (pixels, light_paths) = (whole.pixels.end, whole.light_paths.end);
    // In proportion, and without a gap whatever the two numbers.
    let share = |pixel: u32| {
        (u64::from(pixel) * u64::from(light_paths)).div_euclid(u64::from(pixels)) as u32
    };
    (0..pixels)
        .step_by(CHUNK_PIXELS as usize)
        .map(|start| {
            let range: Range<u32> = start..(start + CHUNK_PIXELS).min(pixels);
            let light_paths = share(range.start)..share(range.end);
            Chunk { pixels: range, light_paths, ..*whole }
        })
        .collect()
}

impl Rendering {
    fn add_pass(&mut self, mut outputs: Vec<ChunkOutput>, width: u32, height: u32) {
        let mut image = PassImage::new(width, height);
        if planted(Defect::SplatsAsAtomics) {
            let some = std::time::UNIX_EPOCH.elapsed().map_or(0, |time| time.subsec_nanos());
            let places = some as usize % outputs.len();
            outputs.rotate_left(places);
        }
        for mut output in outputs {
            // Light for any pixel: a chunk's own, or splats.
            for (pixel, radiance) in output.light {
                image.add(pixel, radiance);
            }
            for (layer, pixel, radiance) in output.layers {
                let sum = self.layers.entry(layer);
                sum.or_insert_with(|| PassImage::new(width, height)).add(pixel, radiance);
            }
            self.notes.append(&mut output.notes);
            self.statistics += output.statistics;
        }
        // The film keeps squares of passes, which are independent; samples are not.
        self.film.add_pass(&image);
    }
}

#[cfg(test)]
mod tests;
