//! Passes that were numbered through.

use super::block::FilmBlock;
use std::ops::Range;

/// Blocks in the order of their passes; no two of them make one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sequence(Vec<FilmBlock>);

impl Sequence {
    /// Its blocks.
    pub(super) fn blocks(&self) -> impl Iterator<Item = &FilmBlock> {
        self.0.iter()
    }

    /// Its blocks, for another.
    pub(super) fn into_blocks(self) -> Vec<FilmBlock> {
        self.0
    }

    /// Returns the number of passes.
    pub(super) fn passes(&self) -> u32 {
        self.0.iter().map(|block| (block.passes().end - block.passes().start) as u32).sum()
    }

    /// Tells whether it has this pass.
    pub(super) fn has(&self, pass: u64) -> bool {
        self.0.iter().any(|block| block.passes().contains(&pass))
    }

    /// The first of these passes that it has.
    pub(super) fn first_of(&self, passes: &Range<u64>) -> Option<u64> {
        let first = |block: &FilmBlock| passes.start.max(block.passes().start);
        let both = |block: &&FilmBlock| first(block) < passes.end.min(block.passes().end);
        self.0.iter().find(both).map(first)
    }

    /// Adds a block of passes that are not there yet.
    pub(super) fn insert(&mut self, block: FilmBlock) {
        let blocks = &mut self.0;
        let mut place = blocks.partition_point(|other| other.passes().start < block.passes().start);
        blocks.insert(place, block);
        // As long as it has become one half of something, and the other half is there.
        loop {
            if place > 0 && blocks[place - 1].joins(&blocks[place]) {
                place -= 1;
            } else if !blocks.get(place + 1).is_some_and(|next| blocks[place].joins(next)) {
                return;
            }
            let next = blocks.remove(place + 1);
            blocks[place].join(&next);
        }
    }
}
