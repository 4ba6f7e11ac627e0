//! Boxes to be opened later.

#![allow(unsafe_code)]

use super::build::MAX_DEPTH;
use super::node::{Child, WIDTH};
use std::mem::MaybeUninit;

/// Each level leaves all but one of its boxes behind; the last has room for all
/// lanes of a node, used or not.
const ROOM: usize = (WIDTH - 1) * MAX_DEPTH + WIDTH;

/// Room for the deepest tree. It is not cleared, which would take longer than many
/// a walk.
pub(crate) struct Stack {
    /// Where the ray enters the boxes. The first `len` are there, as in `children`.
    enter: [MaybeUninit<f32>; ROOM],
    children: [MaybeUninit<Child>; ROOM],
    len: usize,
}

impl Stack {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self {
            enter: [const { MaybeUninit::uninit() }; ROOM],
            children: [const { MaybeUninit::uninit() }; ROOM],
            len: 0,
        }
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
    }

    #[inline(always)]
    pub(crate) fn push(&mut self, enter: f32, child: Child) {
        self.enter[self.len].write(enter);
        self.children[self.len].write(child);
        self.len += 1;
    }

    /// The room for the next eight.
    #[inline(always)]
    pub(crate) fn spare(
        &mut self,
    ) -> (&mut [MaybeUninit<f32>; WIDTH], &mut [MaybeUninit<Child>; WIDTH]) {
        let room = self.len..self.len + WIDTH;
        let (enter, children) = (&mut self.enter[room.clone()], &mut self.children[room]);
        // Never fails: both have this length.
        let (Ok(enter), Ok(children)) = (enter.try_into(), children.try_into()) else {
            unreachable!()
        };
        (enter, children)
    }

    /// Takes over the first `count` of the spare room.
    ///
    /// # Safety
    /// They have been written.
    #[inline(always)]
    pub(crate) unsafe fn grow(&mut self, count: usize) {
        self.len += count;
    }

    /// The topmost box that begins before `limit`; those beyond are dropped.
    #[inline(always)]
    pub(crate) fn pop(&mut self, limit: f32) -> Option<Child> {
        while self.len > 0 {
            self.len -= 1;
            // SAFETY: the first `len` are there, and it was one more.
            let enter = unsafe { self.enter[self.len].assume_init() };
            if enter <= limit {
                // SAFETY: as above.
                return Some(unsafe { self.children[self.len].assume_init() });
            }
        }
        None
    }
}
