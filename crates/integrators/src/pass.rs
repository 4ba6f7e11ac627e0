//! The work of an integrator before a pass is rendered.

use crate::toolkit::Tracer;
use crate::{Chunk, ChunkOutput, Statistics};
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};
use traylib_scene::Scene;

/// The function that renders the chunks of one pass.
pub type RenderChunk<'a> = Box<dyn Fn(&Chunk<'_>, &mut ChunkOutput) + Sync + 'a>;

/// A pass that is about to be rendered.
#[derive(Debug)]
pub struct Pass<'p> {
    scene: &'p Scene,
    chunks: &'p [Chunk<'p>],
    /// Sums of whole numbers: the same in any order.
    statistics: Mutex<Statistics>,
}

impl<'p> Pass<'p> {
    pub(crate) fn new(scene: &'p Scene, chunks: &'p [Chunk<'p>]) -> Self {
        Self { scene, chunks, statistics: Mutex::default() }
    }

    /// Its number, counted from zero.
    pub fn number(&self) -> u64 {
        self.chunks.first().map_or(0, |chunk| chunk.pass)
    }

    /// Does `work` for each chunk, on all threads; the results in the order of the chunks,
    /// so that they do not depend on who did what when. As soon as the pass is given up the
    /// rest is left out: nothing of it will be seen.
    pub fn chunks<T: Send>(
        &self,
        work: impl Fn(&Chunk<'p>, &mut Tracer<'_>) -> T + Sync,
    ) -> Vec<T> {
        let done = |chunk: &Chunk<'p>| {
            if chunk.control.is_cancelled() {
                return None;
            }
            let mut tracer = Tracer::new(self.scene, chunk.control);
            let result = work(chunk, &mut tracer);
            *self.statistics.lock().unwrap_or_else(PoisonError::into_inner) += tracer.statistics;
            Some(result)
        };
        self.chunks.par_iter().filter_map(done).collect()
    }

    /// Returns the counters of its work.
    pub(crate) fn into_statistics(self) -> Statistics {
        self.statistics.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
