//! One picture that waits to be sent.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// A place for one thing from one thread to another: what is put in takes the place of what
/// was not taken out.
#[derive(Debug)]
pub(super) struct Mailbox<T> {
    state: Mutex<State<T>>,
    change: Condvar,
}

#[derive(Debug)]
struct State<T> {
    waiting: Option<T>,
    /// Nothing more is put in.
    is_closed: bool,
    /// Nothing more is taken out.
    is_left: bool,
}

impl<T> Mailbox<T> {
    pub(super) fn new() -> Self {
        let state = State { waiting: None, is_closed: false, is_left: false };
        Self { state: Mutex::new(state), change: Condvar::new() }
    }

    /// Puts in what is newer.
    pub(super) fn put(&self, newest: T) {
        let mut state = self.lock();
        if !state.is_left {
            state.waiting = Some(newest);
        }
        self.change.notify_one();
    }

    /// Waits for what is put in; `None` if nothing more is.
    pub(super) fn take(&self) -> Option<T> {
        let waits = |state: &mut State<T>| state.waiting.is_none() && !state.is_closed;
        let state = self.change.wait_while(self.lock(), waits);
        state.unwrap_or_else(PoisonError::into_inner).waiting.take()
    }

    /// Says that nothing more is put in.
    pub(super) fn close(&self) {
        self.lock().is_closed = true;
        self.change.notify_one();
    }

    /// Says that nothing more is taken out, and tells whether that was not said before.
    pub(super) fn leave(&self) -> bool {
        let mut state = self.lock();
        state.waiting = None;
        !std::mem::replace(&mut state.is_left, true)
    }

    /// Tells whether anything may still be taken out.
    pub(super) fn is_attended(&self) -> bool {
        !self.lock().is_left
    }

    fn lock(&self) -> MutexGuard<'_, State<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_is_taken() {
        let mailbox = Mailbox::new();
        mailbox.put(1);
        mailbox.put(2);
        assert_eq!(mailbox.take(), Some(2));
        mailbox.put(3);
        mailbox.close();
        assert_eq!((mailbox.take(), mailbox.take()), (Some(3), None));
    }

    #[test]
    fn nobody_waits_for_one_who_left() {
        let mailbox = Mailbox::new();
        assert!(mailbox.is_attended() && mailbox.leave());
        mailbox.put(1);
        mailbox.close();
        assert!(!mailbox.is_attended() && !mailbox.leave());
        assert_eq!(mailbox.take(), None);
    }
}
