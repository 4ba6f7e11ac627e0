//! The programs with limits other than their own.

use crate::programs::Program;
use traylib_integrators::{Bdpt, DirectLight, Integrator, Limits, Particle, PureMc};
use traylib_math::Heuristic;

/// All programs that find the light of lamps by way of other surfaces.
pub const PROGRAMS: [Program; 6] = [
    Program::PureMc,
    Program::Strict,
    Program::Combined,
    Program::BdptPower,
    Program::BdptBalance,
    Program::Particle,
];

/// The program's integrator with these limits.
pub fn bounded(program: Program, limits: Limits) -> Box<dyn Integrator> {
    let bdpt = |heuristic| Box::new(Bdpt { limits, heuristic, ..Bdpt::default() });
    match program {
        Program::PureMc => Box::new(PureMc { limits }),
        Program::Strict => Box::new(DirectLight { limits, combine: None }),
        Program::Combined => Box::new(DirectLight { limits, combine: Some(Heuristic::Power) }),
        Program::BdptPower => bdpt(Heuristic::Power),
        Program::BdptBalance => bdpt(Heuristic::Balance),
        Program::Particle => Box::new(Particle { limits }),
    }
}
