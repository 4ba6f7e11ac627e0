//! Right values that came from elsewhere.

use super::who::sees;
use super::{Subject, name, side};
use crate::methods;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::Estimator;

/// Each method that sees the light here against the right value, to the digits that
/// it is written with.
pub(super) fn claims(subject: &Subject<'_>) -> Vec<Claim> {
    let Some(right) = subject.right else { return Vec::new() };
    let methods = methods::WALKING.into_iter().filter(|&method| sees(subject, method));
    let claim = |method| {
        let estimator = Estimator::Method(method);
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
    methods.map(claim).collect()
}
