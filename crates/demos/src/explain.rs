//! The form in which a plan is explained.

/// The form in which a plan is explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Explain {
    /// As tables, for people.
    Text,
    /// As JSON, for programs.
    Json,
}
