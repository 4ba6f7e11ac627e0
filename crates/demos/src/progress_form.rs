//! The form in which a program tells its progress.

use clap::ValueEnum;

/// The form in which a program tells its progress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ProgressForm {
    /// A line that moves, on a terminal
    #[default]
    Line,
    /// A line of JSON on standard output, each second and at the end
    Json,
    /// Lines on standard output as Open Job Description wants them
    Openjd,
}
