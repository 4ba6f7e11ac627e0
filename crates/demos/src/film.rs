//! The program `film`: what picture files hold, and how far two are apart.

mod bias;
mod comparison;
mod diff;
mod info;

pub use diff::DiffOptions;
pub use info::InfoOptions;

use crate::run::conclude;
use clap::Subcommand;
use std::process::ExitCode;

/// What to do with pictures.
#[derive(Subcommand, Clone, Debug)]
pub enum FilmCommand {
    /// Compare two pictures, whichever renderer made them
    Diff(DiffOptions),
    /// Say what is in a file: layers, channels, how it was made
    Info(InfoOptions),
}

impl FilmCommand {
    /// Does it. Ends the program's `main`: prints what went wrong and returns the
    /// exit status.
    pub fn run(&self) -> ExitCode {
        conclude("film", || match self {
            Self::Diff(options) => diff::diff(options),
            Self::Info(options) => info::info(options),
        })
    }
}
