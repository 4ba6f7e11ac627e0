//! Right values that came from elsewhere.

use super::who::sees;
use super::{Subject, name, side};
use crate::programs::Program;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::Estimator;

/// Each program that sees the light here against the right value, to the digits that
/// it is written with.
pub(super) fn claims(subject: &Subject<'_>) -> Vec<Claim> {
    let Some(right) = subject.right else { return Vec::new() };
    let programs = Program::ALL.into_iter().filter(|&program| sees(subject, program));
    let claim = |program| {
        let estimator = Estimator::Program(program);
        Claim {
            what: format!("the mean is {}, {}", right.mean, name(estimator)),
            left: side(subject.drawn, &subject.built, estimator),
            right: Side::Known(right.mean),
            flipped: false,
            factor: 1.0,
            law: Law::MeanOfAll(right.margin),
            numbers: Numbers::Own,
        }
    };
    programs.map(claim).collect()
}
