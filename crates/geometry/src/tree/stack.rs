//! Boxes to be opened later.

#![allow(unsafe_code)]

use super::build::MAX_DEPTH;
use super::node::{Child, WIDTH};
use std::mem::MaybeUninit;

/// Each level leaves all but one of its boxes behind.
const ROOM: usize = (WIDTH - 1) * MAX_DEPTH + 1;

/// A box, and where the ray enters it.
type Waiting = (f32, Child);

/// Room for the deepest tree. It is not cleared, which would take longer than many
/// a walk.
pub(crate) struct Stack {
    /// The first `len` are there.
    waiting: [MaybeUninit<Waiting>; ROOM],
    len: usize,
}

impl Stack {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { waiting: [const { MaybeUninit::uninit() }; ROOM], len: 0 }
    }

    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Puts a box among those above `bottom`, which are sorted, the nearest on top.
    #[inline(always)]
    pub(crate) fn insert(&mut self, bottom: usize, new: Waiting) {
        let mut place = self.len;
        while place > bottom {
            // SAFETY: `place` is at most `len`, so what is below is there.
            let below = unsafe { self.waiting[place - 1].assume_init() };
            if below.0 >= new.0 {
                break;
            }
            self.waiting[place].write(below);
            place -= 1;
        }
        self.waiting[place].write(new);
        self.len += 1;
    }

    /// The topmost box that begins before `limit`; those beyond are dropped.
    #[inline(always)]
    pub(crate) fn pop(&mut self, limit: f32) -> Option<Child> {
        while self.len > 0 {
            self.len -= 1;
            // SAFETY: the first `len` are there, and it was one more.
            let (enter, child) = unsafe { self.waiting[self.len].assume_init() };
            if enter <= limit {
                return Some(child);
            }
        }
        None
    }
}
