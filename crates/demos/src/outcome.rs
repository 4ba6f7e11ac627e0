//! The end of a program, with its exit status.

use crate::signals::Signal;
use std::fmt::{self, Display};
use std::process::ExitCode;

/// The reason why a program could not do what it was asked, and its exit status.
#[derive(Debug)]
pub struct Failure {
    status: u8,
    message: String,
}

impl Failure {
    /// The command line makes no sense: status 2.
    pub fn usage(message: impl Display) -> Self {
        Self::new(2, message)
    }

    /// A scene or a picture could not be read or makes no sense: status 3.
    pub fn scene(message: impl Display) -> Self {
        Self::new(3, message)
    }

    /// Something could not be written, or the system refused, or time was up before
    /// there was a picture: status 4.
    pub fn output(message: impl Display) -> Self {
        Self::new(4, message)
    }

    /// The picture is there, with more noise than was asked for: status 5.
    pub(crate) fn noisy(message: impl Display) -> Self {
        Self::new(5, message)
    }

    /// Films do not fit together, or to what is wanted: status 6.
    pub(crate) fn unfit(message: impl Display) -> Self {
        Self::new(6, message)
    }

    /// Two pictures differ by more than is allowed: status 7.
    pub(crate) fn different(message: impl Display) -> Self {
        Self::new(7, message)
    }

    /// A bug, which has been told of: status 1.
    pub(crate) const BUG: u8 = 1;

    /// Interrupted: status 130 by Ctrl-C, 143 by the system, 129 by a closed terminal.
    pub fn interrupted(signal: Signal, message: impl Display) -> Self {
        Self::new(signal.status(), message)
    }

    fn new(status: u8, message: impl Display) -> Self {
        Self { status, message: message.to_string() }
    }

    /// The exit status.
    pub fn code(&self) -> ExitCode {
        ExitCode::from(self.status)
    }
}

impl From<traylib_io::Error> for Failure {
    #[expect(clippy::wildcard_enum_match_arm, reason = "whatever else is wrong was read")]
    fn from(error: traylib_io::Error) -> Self {
        match error {
            traylib_io::Error::PictureFormat(_) | traylib_io::Error::SceneName(_) => {
                Self::usage(error)
            }
            traylib_io::Error::Write { .. } | traylib_io::Error::Exists(_) => Self::output(error),
            traylib_io::Error::FilmsDiffer { .. } | traylib_io::Error::FilmsOverlap { .. } => {
                Self::unfit(error)
            }
            _ => Self::scene(error),
        }
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A scene's report brings its own first word.
        let word = if self.message.starts_with("error") { "" } else { "error: " };
        write!(f, "{word}{}", self.message)
    }
}
