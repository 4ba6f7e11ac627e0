//! A word with a rendering that is under way.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// The signals between a rendering and those who wait for it, from any thread.
///
/// A pass is given up by asking: every ray looks at [`is_cancelled`](Self::is_cancelled),
/// so that a walk without end is heard out no more than a pass of many hours.
#[derive(Debug, Default)]
pub struct Control {
    cancelled: AtomicBool,
    chunks: AtomicU32,
    chunks_done: AtomicU32,
}

impl Control {
    /// Asks the rendering to end; the pass under way is given up.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Tells whether it has been asked to end.
    #[inline]
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Returns the part of the pass under way that is done, or was when it was given up: from zero
    /// to one, in chunks.
    pub fn part_of_pass(&self) -> f64 {
        let chunks = self.chunks.load(Ordering::Relaxed).max(1);
        f64::from(self.chunks_done.load(Ordering::Relaxed)) / f64::from(chunks)
    }

    /// A pass of so many chunks begins.
    pub(crate) fn begin_pass(&self, chunks: usize) {
        self.chunks_done.store(0, Ordering::Relaxed);
        self.chunks.store(chunks as u32, Ordering::Relaxed);
    }

    /// A chunk is done.
    pub(crate) fn end_chunk(&self) {
        self.chunks_done.fetch_add(1, Ordering::Relaxed);
    }
}
