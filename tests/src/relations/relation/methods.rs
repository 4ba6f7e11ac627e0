//! Methods against one another.

use super::who::sees;
use super::{Subject, side};
use crate::methods::{BDPT, BDPT_BALANCE, COMBINED, beginning_with};
use crate::relations::judge::{Claim, Law, Numbers};
use crate::relations::render::Estimator;

/// The relative difference of means that rounding may cause.
const ROUNDING: f64 = 2e-5;

/// Each method that sees the light here against the first of them.
pub(super) fn claims(subject: &Subject<'_>) -> Vec<Claim> {
    let order = beginning_with(&[BDPT, COMBINED, BDPT_BALANCE]);
    let mut seeing = order.into_iter().filter(|&method| sees(subject, method));
    let Some(first) = seeing.next() else { return Vec::new() };
    let by = |method| side(subject.drawn, &subject.built, Estimator::Method(method));
    let claim = |other| Claim {
        what: format!("{first} = {other}"),
        left: by(first),
        right: by(other),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(ROUNDING),
        numbers: Numbers::Own,
    };
    seeing.map(claim).collect()
}
