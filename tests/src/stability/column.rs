//! The columns of the table: programs.

use crate::programs::Program;
use serde::{Deserialize, Serialize};
use traylib_integrators::{Integrator, Trace};

/// A program under judgement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Column {
    /// `trace`, with jitter: all others estimate the mean over a pixel.
    Trace,
    /// `puremc`.
    PureMc,
    /// `directlight`, strict.
    DirectLight,
    /// `directlight --combine`, power heuristic.
    Combined,
    /// `particle`.
    Particle,
    /// `bdpt`, power heuristic.
    Bdpt,
}

impl Column {
    /// All, in the order of the table.
    pub const ALL: [Self; 6] =
        [Self::Trace, Self::PureMc, Self::DirectLight, Self::Combined, Self::Particle, Self::Bdpt];

    /// The word for it, on the command line and in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Trace => "trace",
            Self::PureMc => "puremc",
            Self::DirectLight => "directlight",
            Self::Combined => "combined",
            Self::Particle => "particle",
            Self::Bdpt => "bdpt",
        }
    }

    /// The integrator, for paths of at most `max_depth` edges.
    pub fn integrator(self, max_depth: Option<u32>) -> Box<dyn Integrator> {
        let program = match self {
            Self::Trace => return Box::new(Trace { jitter: true }),
            Self::PureMc => Program::PureMc,
            Self::DirectLight => Program::Strict,
            Self::Combined => Program::Combined,
            Self::Particle => Program::Particle,
            Self::Bdpt => Program::BdptPower,
        };
        program.integrator(max_depth)
    }
}
