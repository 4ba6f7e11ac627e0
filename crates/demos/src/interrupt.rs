//! Being asked to stop: Ctrl-C, a closed terminal, a system going down, time that is up.

use crate::messages::say;
use crate::outcome::Failure;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;
use traylib_integrators::Control;

/// Does this at the first request to stop; the second stops at once, with a line.
///
/// Pictures are written beside their target and renamed, so even that leaves no
/// half of one.
pub fn on_interrupt(first: impl Fn() + Send + 'static) {
    let asked = AtomicBool::new(false);
    // Without a handler the system's own way to stop still works.
    let _ = ctrlc::set_handler(move || {
        if asked.swap(true, Ordering::Relaxed) {
            say("error: interrupted again; stopped at once");
            std::process::exit(130);
        }
        first();
    });
}

/// A rendering that can be asked to stop, and what asked it.
#[derive(Debug, Default)]
pub(crate) struct Stop {
    /// What the rendering listens to.
    pub(crate) control: Control,
    interrupted: AtomicBool,
}

impl Stop {
    /// Stops when the user or the system says so, and does `answer` then.
    pub(crate) fn on_interrupt(self: &Arc<Self>, answer: impl Fn() + Send + 'static) {
        let stop = Arc::clone(self);
        on_interrupt(move || {
            stop.interrupted.store(true, Ordering::Relaxed);
            stop.control.cancel();
            answer();
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

    /// Whether the user or the system asked, not the clock.
    pub(crate) fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }
}
