//! The order in which lines are read: objects, transforms and includes.

use super::Reader;
use crate::Limit;
use crate::mgf::budget::limit;
use crate::mgf::error::shown;
use crate::mgf::keyword::Keyword;
use crate::mgf::{Cause, WarningKind};

/// Work beside reading, in bytes of text; of a copy for each part of its arguments.
const COPY_COST: u64 = 128;
const INCLUDE_COST: u64 = 128;
const OBJECT_COST: u64 = 16;
/// A word among the arguments of a transform.
const ARGUMENT_COST: u64 = 8;
/// A transform to repeat, by doubling up to 64 times.
const REPEAT_COST: u64 = 512;

/// Returns the cost of making a transform.
fn cost(arguments: &[&str]) -> u64 {
    let repeats = arguments.iter().filter(|word| matches!(**word, "-i" | "-a")).count() as u64;
    arguments.len() as u64 * ARGUMENT_COST + repeats * REPEAT_COST
}

impl Reader<'_> {
    pub(super) fn object(&mut self, words: &[&str]) -> Result<(), Cause> {
        self.work.take(OBJECT_COST)?;
        let Some(call) = self.calls.last_mut() else { return Ok(()) };
        match words {
            [] => call.objects = call.objects.checked_sub(1).ok_or(Cause::Unmatched)?,
            [_] => call.objects += 1,
            _ => {
                let expected = "nothing or a name";
                return Err(Cause::Arguments { expected, found: words.len() });
            }
        }
        Ok(())
    }

    pub(super) fn transform(&mut self, words: &[&str]) -> Result<(), Cause> {
        let Some(call) = self.calls.last_mut() else { return Ok(()) };
        if !words.is_empty() {
            self.work.take(cost(words))?;
            return self.frames.open(words, call.next);
        }
        if self.frames.depth() <= call.frames {
            return Err(Cause::Unmatched);
        }
        self.next_copy()
    }

    /// Ends the innermost transform, or goes back to the beginning of its text.
    fn next_copy(&mut self) -> Result<(), Cause> {
        self.work.take(COPY_COST * self.frames.segments())?;
        if let (Some(start), Some(call)) = (self.frames.advance(), self.calls.last_mut()) {
            call.next = start;
        }
        Ok(())
    }

    pub(super) fn include(&mut self, words: &[&str]) -> Result<(), Cause> {
        let Some((name, arguments)) = words.split_first() else {
            return Err(Cause::Arguments { expected: "a file and a transform", found: 0 });
        };
        self.work.take(INCLUDE_COST + cost(arguments))?;
        let depth = self.calls.len() as u64;
        limit("files inside each other", depth, self.options.max_depth as u64, Limit::Depth)?;
        let Some(call) = self.calls.last() else { return Ok(()) };
        let Self { files, work, memory, .. } = self;
        let source = files.included((&call.source, name), work, memory)?;
        if self.calls.iter().any(|call| call.source.id == source.id) {
            return Err(Cause::Circle(shown(name)));
        }
        if !arguments.is_empty() {
            self.frames.open(arguments, 0)?;
            self.count(Keyword::Transform);
        }
        self.enter(source, !arguments.is_empty());
        Ok(())
    }

    /// Closes what the file leaves open, then reads it again for the next copy
    /// of its arguments or goes back to the file that includes it.
    pub(super) fn end_of_file(&mut self) -> Result<(), Cause> {
        let Some(call) = self.calls.last_mut() else { return Ok(()) };
        let (frames, transformed) = (call.frames, call.transformed);
        if self.frames.depth() > frames {
            self.warn(WarningKind::TransformLeftOpen, "");
            return self.next_copy();
        }
        if std::mem::take(&mut call.objects) > 0 {
            self.warn(WarningKind::ObjectLeftOpen, "");
        }
        if transformed {
            self.count(Keyword::Transform);
            self.next_copy()?;
            if self.frames.depth() == frames {
                return Ok(());
            }
        }
        self.calls.pop();
        Ok(())
    }
}
