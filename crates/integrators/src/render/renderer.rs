//! Passes one by one, each in chunks.

use super::Rendering;
use crate::{
    Chunk, ChunkOutput, Control, Dimensions, Integrator, Pass, PointSet, RenderChunk, Statistics,
};
use rayon::ThreadPool;
use rayon::prelude::*;
use std::ops::Range;
use traylib_scene::{Film, PassImage, Scene};

/// Pixels in a chunk. Part of the result: sums are formed chunk by chunk.
const CHUNK_PIXELS: u32 = 256;

/// Chunks for each thread of which the light is kept until it is added up. So many that
/// threads seldom wait for the last of them, so few that they need no memory to speak of.
const CHUNKS_IN_FLIGHT: usize = 64;

/// A rendering that is under way: one pass after the other, or any passes, on the threads of
/// whoever asks for them. [`render`](super::render) is the loop around it.
///
/// Two renderings of the same scene, integrator and seed fit together: what one has not
/// rendered the other may, and [`Film::merge`] makes of both films that of one rendering.
pub struct Renderer<'a> {
    scene: &'a Scene,
    integrator: &'a dyn Integrator,
    seed: u64,
    points: PointSet,
    dimensions: Dimensions,
    rendering: Rendering,
}

impl std::fmt::Debug for Renderer<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Renderer").field("seed", &self.seed).finish_non_exhaustive()
    }
}

impl<'a> Renderer<'a> {
    /// Begins without a pass.
    pub fn new(
        scene: &'a Scene,
        integrator: &'a dyn Integrator,
        seed: u64,
        points: PointSet,
    ) -> Self {
        let (width, height) = (scene.camera().width(), scene.camera().height());
        let film = Film::of_sequences(width, height, points.sequences());
        let rendering = Rendering { film, notes: Vec::new(), statistics: Statistics::default() };
        Self { scene, integrator, seed, points, dimensions: Dimensions::of(scene), rendering }
    }

    /// Goes on with the passes of a film that was rendered before.
    ///
    /// # Panics
    /// If the film has another size than the scene's pictures, or other sequences than the
    /// points.
    #[must_use]
    pub fn going_on_from(mut self, film: Film) -> Self {
        let own = &self.rendering.film;
        let form = |film: &Film| (film.width(), film.height(), film.sequences().len());
        assert_eq!(form(own), form(&film), "size and sequences of the film that is gone on from");
        self.rendering.film = film;
        self
    }

    /// Returns the result of the passes so far.
    pub fn rendering(&self) -> &Rendering {
        &self.rendering
    }

    /// Returns the result of all passes.
    pub fn finish(self) -> Rendering {
        self.rendering
    }

    /// Renders the pass of this number, on the threads of the pool that it is called in.
    /// Returns false if `control` was cancelled meanwhile; that pass leaves no trace.
    ///
    /// # Panics
    /// If the film has this pass.
    pub fn render_pass(&mut self, number: u32, control: &Control) -> bool {
        let sums = self.pass_sums(number, control);
        self.add(number, sums)
    }

    /// [`render_pass`](Self::render_pass) on the threads of `pool`, while the thread that calls
    /// it does something else with what came of the passes before.
    ///
    /// # Panics
    /// If the film has this pass.
    pub fn render_pass_beside(
        &mut self,
        number: u32,
        control: &Control,
        pool: &ThreadPool,
        meanwhile: impl FnOnce(&Rendering),
    ) -> bool {
        let (renderer, mut sums) = (&*self, None);
        pool.in_place_scope(|scope| {
            scope.spawn(|_| sums = renderer.pass_sums(number, control));
            meanwhile(&renderer.rendering);
        });
        self.add(number, sums)
    }

    /// The light of a pass that is not in the film yet; `None` if it was given up.
    fn pass_sums(&self, number: u32, control: &Control) -> Option<PassSums> {
        assert!(!self.rendering.film.has_pass(number), "pass {number} is rendered");
        if control.is_cancelled() {
            return None;
        }
        let chunks = self.chunks(number, control);
        // Whoever waits can see how far it is.
        control.begin_pass(chunks.len());
        // Light work that all chunks share comes first.
        let pass = Pass::new(self.scene, &chunks);
        let with_memory = self.integrator.begin_pass(self.scene, &pass);
        let light_work = pass.into_statistics();
        let mut sums = PassSums::new(self.scene, light_work);
        for chunks in chunks.chunks(CHUNKS_IN_FLIGHT * rayon::current_num_threads()) {
            // By any thread in any order; sums are formed in the order of the chunks.
            let outputs: Option<Vec<ChunkOutput>> = chunks
                .par_iter()
                .map(|chunk| self.render_chunk(chunk, with_memory.as_ref()))
                .collect();
            sums.add(outputs?);
        }
        Some(sums)
    }

    /// Adds a pass to what came of those before, and tells whether there is one.
    fn add(&mut self, number: u32, sums: Option<PassSums>) -> bool {
        let Some(PassSums { image, notes, statistics }) = sums else { return false };
        self.rendering.film.add_pass(number, image);
        self.rendering.notes.extend(notes);
        self.rendering.statistics += statistics;
        true
    }

    /// Returns the contribution of a chunk to its pass, from what the light work left, or from the
    /// chunk alone; `None` if the pass was given up meanwhile.
    /// `None` if the pass was given up meanwhile.
    fn render_chunk(
        &self,
        chunk: &Chunk<'_>,
        with_memory: Option<&RenderChunk<'_>>,
    ) -> Option<ChunkOutput> {
        let mut out = ChunkOutput::default();
        match with_memory {
            _ if chunk.control.is_cancelled() => {}
            Some(render_chunk) => render_chunk(chunk, &mut out),
            None => self.integrator.render_chunk(self.scene, chunk, &mut out),
        }
        // What was cancelled on its way may lack anything.
        if chunk.control.is_cancelled() {
            return None;
        }
        chunk.control.end_chunk();
        Some(out)
    }

    /// Cuts a pass into chunks, its light paths in proportion to its pixels.
    fn chunks<'c>(&self, pass: u32, control: &'c Control) -> Vec<Chunk<'c>> {
        let pixels = self.scene.camera().width() * self.scene.camera().height();
        let light_paths = self.integrator.light_paths(pixels);
        // In proportion, and without a gap whatever the two numbers.
        let share = |pixel: u32| {
            (u64::from(pixel) * u64::from(light_paths)).div_euclid(u64::from(pixels)) as u32
        };
        let chunk = |start: u32| {
            let range: Range<u32> = start..(start + CHUNK_PIXELS).min(pixels);
            Chunk {
                seed: self.seed,
                pass: pass.into(),
                light_paths: share(range.start)..share(range.end),
                light_path_count: light_paths,
                pixels: range,
                points: self.points,
                dimensions: self.dimensions,
                control,
            }
        };
        (0..pixels).step_by(CHUNK_PIXELS as usize).map(chunk).collect()
    }
}

/// The sums of the chunks of a pass so far.
struct PassSums {
    image: PassImage,
    notes: Vec<String>,
    statistics: Statistics,
}

impl PassSums {
    /// No light yet, and the work that was done for all chunks together.
    fn new(scene: &Scene, statistics: Statistics) -> Self {
        let image = PassImage::new(scene.camera().width(), scene.camera().height());
        Self { image, notes: Vec::new(), statistics }
    }

    fn add(&mut self, outputs: Vec<ChunkOutput>) {
        for mut output in outputs {
            // Light for any pixel: a chunk's own, or splats.
            for (pixel, radiance) in output.light {
                self.image.add(pixel, radiance);
            }
            for (layer, pixel, radiance) in output.layers {
                self.image.add_to_layer(layer, pixel, radiance);
            }
            self.notes.append(&mut output.notes);
            self.statistics += output.statistics;
        }
    }
}
