//! Programs against one another.

use super::who::sees;
use super::{Subject, side};
use crate::programs::Program;
use crate::relations::judge::{Claim, Law, Numbers};
use crate::relations::render::Estimator;

/// How far means may be apart for rounding.
const ROUNDING: f64 = 2e-5;

/// Each program that sees the light here against the first of them.
pub(super) fn claims(subject: &Subject<'_>) -> Vec<Claim> {
    use Program::{BdptBalance, BdptPower, Combined, Particle, PureMc, Strict};
    let order = [BdptPower, Combined, BdptBalance, PureMc, Strict, Particle];
    let mut seeing = order.into_iter().filter(|&program| sees(subject, program));
    let Some(first) = seeing.next() else { return Vec::new() };
    let by = |program| side(subject.drawn, &subject.built, Estimator::Program(program));
    let claim = |other| Claim {
        what: format!("{first:?} = {other:?}"),
        left: by(first),
        right: by(other),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(ROUNDING),
        numbers: Numbers::Own,
    };
    seeing.map(claim).collect()
}
