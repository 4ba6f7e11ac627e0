//! The program `film`: what picture files hold, how far two are apart, one format made
//! another, and one film of many.

mod any;
mod bias;
mod comparison;
mod convert;
mod denoise;
mod diff;
mod info;
mod merge;

pub use convert::ConvertOptions;
pub use denoise::DenoiseOptions;
pub use diff::DiffOptions;
pub use info::InfoOptions;
pub use merge::MergeOptions;

use crate::conclude::conclude;
use clap::Subcommand;
use std::process::ExitCode;

/// The commands on pictures.
#[derive(Subcommand, Clone, Debug)]
pub enum FilmCommand {
    /// Compare two pictures, whichever renderer made them
    Diff(DiffOptions),
    /// Say what is in a file: layers, channels, how it was made
    Info(InfoOptions),
    /// Write a picture in another format
    Convert(ConvertOptions),
    /// Make one film of the films of parts (--shard)
    Merge(MergeOptions),
    /// Make a picture with less noise of a film; it is biased
    Denoise(DenoiseOptions),
}

impl FilmCommand {
    /// Does it. Ends the program's `main`: prints what went wrong and returns the
    /// exit status.
    pub fn run(&self) -> ExitCode {
        conclude("film", || match self {
            Self::Diff(options) => diff::diff(options),
            Self::Info(options) => info::info(options),
            Self::Convert(options) => convert::convert(options),
            Self::Merge(options) => merge::merge(options),
            Self::Denoise(options) => denoise::denoise_film(options),
        })
    }
}
