//! Being asked to stop: Ctrl-C, a closed terminal, a system going down, time that is up.

use crate::outcome::Failure;
use crate::say::say;
use crate::signals::{self, Signal};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;
use traylib_integrators::Control;

type Answer = Box<dyn Fn(Signal) + Send>;

/// The answer to the first request to stop; nothing before there is work to keep.
static ANSWER: Mutex<Option<Answer>> = Mutex::new(None);

/// Listens to requests to stop from now on: the second stops at once, with a line, and
/// so does the first as long as [`on_interrupt`] has not said what else to do.
///
/// Files are written beside their target and renamed, so even that leaves no half of
/// one, neither under its name nor beside it.
pub(crate) fn listen() {
    let asked = AtomicBool::new(false);
    signals::listen(move |signal| {
        let again = asked.swap(true, Ordering::Relaxed);
        let answer = ANSWER.lock().unwrap_or_else(PoisonError::into_inner);
        match &*answer {
            Some(answer) if !again => answer(signal),
            _ => stop_at_once(signal, again),
        }
    });
}

fn stop_at_once(signal: Signal, again: bool) -> ! {
    let again = if again { " again" } else { "" };
    traylib_io::discard_unfinished();
    say(format_args!("error: interrupted{again}; stopped at once"));
    std::process::exit(i32::from(signal.status()))
}

/// Does this at the first request to stop.
pub fn on_interrupt(first: impl Fn(Signal) + Send + 'static) {
    *ANSWER.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(first));
}

/// A rendering that can be asked to stop, and what asked it.
#[derive(Debug, Default)]
pub(crate) struct Stop {
    /// The control that the rendering listens to.
    pub(crate) control: Control,
    interrupted: OnceLock<Signal>,
}

impl Stop {
    /// Stops when the user or the system says so, and does `answer` then.
    pub(crate) fn on_interrupt(self: &Arc<Self>, answer: impl Fn(Signal) + Send + 'static) {
        let stop = Arc::clone(self);
        on_interrupt(move |signal| {
            stop.interrupted.get_or_init(|| signal);
            stop.control.cancel();
            answer(signal);
        });
    }

    /// Stops after this time. A thread of its own waits for it: those that render may be
    /// busy with one path.
    ///
    /// # Errors
    /// The system refuses the thread.
    pub(crate) fn after(self: &Arc<Self>, time: Duration) -> Result<(), Failure> {
        let stop = Arc::clone(self);
        let wait = move || {
            thread::sleep(time);
            stop.control.cancel();
        };
        let thread = thread::Builder::new().name("time limit".into()).spawn(wait);
        thread.map(drop).map_err(|error| {
            Failure::output(format_args!("--time-limit: cannot start a thread: {error}"))
        })
    }

    /// Tells by which signal the user or the system asked, if it was not the clock.
    pub(crate) fn interrupted(&self) -> Option<Signal> {
        self.interrupted.get().copied()
    }
}
