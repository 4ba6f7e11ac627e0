//! Open transforms, the innermost last.

use super::array::Copies;
use super::budget::limit;
use super::transform::Transform;
use super::{Cause, Options};
use crate::Limit;

/// The stack of transforms.
pub(super) struct Frames {
    open: Vec<Frame>,
    most: usize,
    most_copies: u64,
}

struct Frame {
    copies: Copies,
    /// The copy that is being read.
    index: u64,
    /// Copies of this and all outer frames together.
    multiplicity: u64,
    /// From here to the world.
    total: Transform,
    /// The position at which its text begins.
    start: usize,
}

impl Frames {
    pub(super) fn new(options: &Options) -> Self {
        let (most, most_copies) = (options.max_transforms, options.max_surfaces);
        Self { open: Vec::new(), most, most_copies }
    }

    pub(super) fn depth(&self) -> usize {
        self.open.len()
    }

    /// Parts of the innermost frame's arguments that a copy of it takes.
    pub(super) fn segments(&self) -> u64 {
        self.open.last().map_or(0, |frame| frame.copies.segments())
    }

    /// From the current frame to the world.
    pub(super) fn total(&self) -> Transform {
        self.open.last().map_or(Transform::IDENTITY, |frame| frame.total)
    }

    /// Opens a frame whose text begins at `start`. How many copies it asks for,
    /// times those of the frames around it, is bounded before any is made.
    pub(super) fn open(&mut self, words: &[&str], start: usize) -> Result<(), Cause> {
        let copies = Copies::parse(words)?;
        let outer = self.open.last().map_or(1, |frame| frame.multiplicity);
        let multiplicity = outer.saturating_mul(copies.count());
        limit("copies", multiplicity, self.most_copies, Limit::Surfaces)?;
        limit("open transforms", self.depth() as u64 + 1, self.most as u64, Limit::Transforms)?;
        let total = copies.transform(0).then(&self.total());
        self.open.push(Frame { copies, index: 0, multiplicity, total, start });
        Ok(())
    }

    /// Ends the text of the innermost frame: where to read it again for its next
    /// copy, or `None` after the last, with the frame closed.
    pub(super) fn advance(&mut self) -> Option<usize> {
        let mut frame = self.open.pop()?;
        frame.index += 1;
        if frame.index >= frame.copies.count() {
            return None;
        }
        frame.total = frame.copies.transform(frame.index).then(&self.total());
        let start = frame.start;
        self.open.push(frame);
        Some(start)
    }
}
