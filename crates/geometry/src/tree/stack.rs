//! Boxes to be opened later.

#![allow(unsafe_code)]

use super::build::MAX_DEPTH;
use super::node::{Child, WIDTH};
use std::mem::MaybeUninit;

/// A level leaves all but one of its boxes behind; the last has room for all boxes
/// of a node, used or not.
const CAPACITY: usize = (WIDTH - 1) * MAX_DEPTH + WIDTH;

/// Memory for the boxes of the deepest tree. It is not cleared, which would take
/// longer than many a walk.
pub(crate) struct StackMemory {
    enter: [MaybeUninit<f32>; CAPACITY],
    children: [MaybeUninit<Child>; CAPACITY],
}

impl StackMemory {
    #[inline(always)]
    pub(crate) const fn new() -> Self {
        Self {
            enter: [const { MaybeUninit::uninit() }; CAPACITY],
            children: [const { MaybeUninit::uninit() }; CAPACITY],
        }
    }
}

/// The boxes that wait, with where the ray enters them.
pub(crate) struct Stack<'a> {
    memory: &'a mut StackMemory,
    /// The number of entries. Not beside the boxes, so that it can stay in a register.
    len: usize,
}

impl<'a> Stack<'a> {
    #[inline(always)]
    pub(crate) fn new(memory: &'a mut StackMemory) -> Self {
        Self { memory, len: 0 }
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
    }

    #[inline(always)]
    pub(crate) fn push(&mut self, enter: f32, child: Child) {
        self.memory.enter[self.len].write(enter);
        self.memory.children[self.len].write(child);
        self.len += 1;
    }

    /// The room for the next eight.
    #[inline(always)]
    pub(crate) fn spare(
        &mut self,
    ) -> (&mut [MaybeUninit<f32>; WIDTH], &mut [MaybeUninit<Child>; WIDTH]) {
        let room = self.len..self.len + WIDTH;
        let (enter, children) =
            (&mut self.memory.enter[room.clone()], &mut self.memory.children[room]);
        // Never fails: both have this length.
        let (Ok(enter), Ok(children)) = (enter.try_into(), children.try_into()) else {
            unreachable!()
        };
        (enter, children)
    }

    /// Takes over the first `count` of the spare room.
    ///
    /// # Safety
    /// They have been written since the last change of the stack; they are eight at
    /// most.
    #[inline(always)]
    pub(crate) unsafe fn grow(&mut self, count: usize) {
        self.len += count;
    }

    /// The topmost box.
    #[inline(always)]
    pub(crate) fn top(&self) -> Option<Child> {
        let top = self.len.checked_sub(1)?;
        // SAFETY: the first `len` are there.
        Some(unsafe { self.memory.children.get_unchecked(top).assume_init() })
    }

    /// The topmost box that begins before `limit`; those beyond are dropped.
    #[inline(always)]
    pub(crate) fn pop(&mut self, limit: f32) -> Option<Child> {
        while self.len > 0 {
            self.len -= 1;
            // SAFETY: the first `len` are there, and before it was one more.
            let enter = unsafe { self.memory.enter.get_unchecked(self.len).assume_init() };
            if enter <= limit {
                // SAFETY: as above.
                let child = unsafe { self.memory.children.get_unchecked(self.len).assume_init() };
                return Some(child);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_box_comes_first_and_those_beyond_are_dropped() {
        let mut memory = StackMemory::new();
        let mut stack = Stack::new(&mut memory);
        assert_eq!((stack.top(), stack.pop(f32::INFINITY)), (None, None));
        for (index, enter) in [1.0, 4.0, 2.0, 8.0].into_iter().enumerate() {
            stack.push(enter, Child::node(index));
        }
        assert_eq!(stack.top(), Some(Child::node(3)));
        assert_eq!(stack.pop(2.0), Some(Child::node(2)));
        assert_eq!(stack.pop(2.0), Some(Child::node(0)));
        assert_eq!(stack.pop(2.0), None);
        stack.push(1.0, Child::node(5));
        stack.clear();
        assert_eq!(stack.top(), None);
    }

    /// The tree is as deep as it can be: seven stay behind on each level.
    #[test]
    fn spare_room_is_taken_over_and_suffices() {
        let mut memory = StackMemory::new();
        let mut stack = Stack::new(&mut memory);
        for level in 0..=MAX_DEPTH {
            let kept = if level < MAX_DEPTH { WIDTH - 1 } else { WIDTH };
            let (enter, children) = stack.spare();
            for lane in 0..kept {
                enter[lane].write(lane as f32);
                children[lane].write(Child::node(WIDTH * level + lane));
            }
            // SAFETY: so many were written just now.
            unsafe { stack.grow(kept) };
        }
        let mut taken = 0;
        while let Some(child) = stack.pop(0.0) {
            taken += 1;
            assert_eq!(child, Child::node(WIDTH * (MAX_DEPTH + 1 - taken)));
        }
        assert_eq!(taken, MAX_DEPTH + 1);
    }
}
