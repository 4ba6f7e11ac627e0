//! Requests of the system to a program.

/// A request to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// The terminal was closed.
    Hangup,
    /// Ctrl-C.
    Interrupt,
    /// The system or another program wants it.
    Terminate,
}

impl Signal {
    /// The exit status of a program that has obeyed: 128 and the signal's number.
    pub fn status(self) -> u8 {
        match self {
            Self::Hangup => 129,
            Self::Interrupt => 130,
            Self::Terminate => 143,
        }
    }
}

/// Writes the name that its sender knows it by.
impl std::fmt::Display for Signal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Hangup => "SIGHUP",
            Self::Interrupt => "interrupt",
            Self::Terminate => "SIGTERM",
        })
    }
}

pub(crate) use system::listen;

#[cfg(unix)]
mod system {
    use super::Signal;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::flag;
    use signal_hook::iterator::Signals;
    use std::sync::Arc;
    use std::thread;

    /// Does `answer` at each request to end, in a thread of its own.
    ///
    /// Where that fails, the system's own way to stop still works. A closed terminal
    /// that was ignored when the program began stays so, as under `nohup`; Ctrl-C, which
    /// shells ignore for what scripts start in the background, is for whoever sends it.
    pub(crate) fn listen(mut answer: impl FnMut(Signal) + Send + 'static) {
        // A file beyond the size that is allowed is then an error of writing, not the
        // end; nobody looks at the flag.
        let _ = flag::register(SIGXFSZ, Arc::default());
        let hangup = (!is_ignored(SIGHUP)).then_some(SIGHUP);
        let wanted = [SIGINT, SIGTERM].into_iter().chain(hangup);
        let Ok(mut signals) = Signals::new(wanted) else { return };
        let wait = move || {
            for number in signals.forever() {
                answer(match number {
                    SIGHUP => Signal::Hangup,
                    SIGTERM => Signal::Terminate,
                    _ => Signal::Interrupt,
                });
            }
        };
        let _ = thread::Builder::new().name("signals".into()).spawn(wait);
    }

    /// Asks the process's own entry where there is one, on Linux.
    fn is_ignored(number: i32) -> bool {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
        mask.is_some_and(|mask| mask >> (number - 1) & 1 == 1)
    }
}

#[cfg(not(unix))]
mod system {
    use super::Signal;

    /// Does `answer` at each request to end, in a thread of its own.
    ///
    /// Where that fails, the system's own way to stop still works.
    pub(crate) fn listen(mut answer: impl FnMut(Signal) + Send + 'static) {
        let _ = ctrlc::set_handler(move || answer(Signal::Interrupt));
    }
}
