//! The integrators by the names of their programs.

use traylib_integrators::{Bdpt, DirectLight, Integrator, Limits, Particle, PureMc, Roulette};
use traylib_math::Heuristic;

/// An estimator under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// `puremc`.
    PureMc,
    /// `directlight`, as strict as the paper.
    Strict,
    /// `directlight --combine`.
    Combined,
    /// `bdpt`, weights by the power heuristic.
    BdptPower,
    /// `bdpt`, weights by the balance heuristic.
    BdptBalance,
    /// `particle`.
    Particle,
}

impl Program {
    /// All that walk from the camera, and so see a spot as well as a wide view.
    pub const FROM_CAMERA: [Self; 5] =
        [Self::PureMc, Self::Strict, Self::Combined, Self::BdptPower, Self::BdptBalance];

    /// All that find the light of lamps by way of other surfaces.
    pub const ALL: [Self; 6] = [
        Self::PureMc,
        Self::Strict,
        Self::Combined,
        Self::BdptPower,
        Self::BdptBalance,
        Self::Particle,
    ];

    /// The integrator, for paths of at most `max_depth` edges.
    pub fn integrator(self, max_depth: Option<u32>) -> Box<dyn Integrator> {
        self.within(Limits { max_depth, roulette: Roulette::default() })
    }

    /// The integrator with these limits.
    pub fn within(self, limits: Limits) -> Box<dyn Integrator> {
        let bdpt = |heuristic| Box::new(Bdpt { limits, heuristic, ..Bdpt::default() });
        match self {
            Self::PureMc => Box::new(PureMc { limits }),
            Self::Strict => Box::new(DirectLight { limits, combine: None }),
            Self::Combined => Box::new(DirectLight { limits, combine: Some(Heuristic::Power) }),
            Self::BdptPower => bdpt(Heuristic::Power),
            Self::BdptBalance => bdpt(Heuristic::Balance),
            Self::Particle => Box::new(Particle { limits }),
        }
    }
}
