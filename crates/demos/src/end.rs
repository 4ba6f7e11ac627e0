//! The event that ended a rendering.

use crate::outcome::Failure;
use crate::signals::Signal;

/// The event that ended a rendering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// All passes are done.
    Spp,
    /// The time is up.
    TimeLimit,
    /// The error is no more than was asked for.
    Noise,
    /// None is left for another pass.
    Memory,
    /// The user or the system asked for it.
    Interrupt(Signal),
}

impl End {
    /// In a word or two.
    pub(crate) fn words(self) -> String {
        match self {
            Self::Spp => "--spp".into(),
            Self::TimeLimit => "--time-limit".into(),
            Self::Noise => "--noise".into(),
            Self::Memory => "lack of memory for more".into(),
            Self::Interrupt(signal) => signal.to_string(),
        }
    }

    /// Says why nothing is written: it came when this part of the first pass was done.
    pub(crate) fn without_pass(self, part: f64) -> Failure {
        let percent = (100.0 * part) as u32;
        let nothing = format!("the first pass was done to {percent} %; nothing is written");
        match self {
            Self::Interrupt(signal) => {
                Failure::interrupted(signal, format_args!("interrupted while {nothing}"))
            }
            Self::Spp | Self::TimeLimit | Self::Noise | Self::Memory => {
                Failure::output(format_args!(
                    "the time was up while {nothing}; a smaller --resolution or a longer --time-limit may help"
                ))
            }
        }
    }
}
