//! Some techniques of `bdpt`, weighted among themselves.

use super::who::sees;
use super::{Subject, side};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers};
use crate::relations::render::Estimator;
use crate::relations::scene::Object;
use traylib_integrators::TechniqueSet;

/// A set of techniques that finds every path: hits of lamps where there is no point,
/// light samples where there is no mirror, and others by chance.
pub(super) fn claims(subject: &Subject<'_>, dice: &mut Dice) -> Vec<Claim> {
    let drawn = subject.drawn;
    let Some(longest) = drawn.max_depth.filter(|&depth| depth <= 6) else { return Vec::new() };
    // Edges of no length have no density.
    if !drawn.is_clear()
        || !sees(subject, methods::BDPT_BALANCE)
        || !sees(subject, methods::COMBINED)
    {
        return Vec::new();
    }
    let all_are_points = !drawn.objects.iter().any(Object::is_light);
    let mut pairs = vec![(0, 2)];
    for k in 2..=longest as usize {
        let by_samples = all_are_points || !drawn.has_mirrors() && dice.chance(0.5);
        // What hits find of small lamps is too rare to be judged; both together are not.
        let sure = if by_samples { vec![1] } else { vec![0, 1] };
        pairs.extend(sure.into_iter().map(|s| (s, k + 1 - s)));
        pairs.extend((2..=k).filter(|_| dice.chance(0.4)).map(|s| (s, k + 1 - s)));
    }
    let set = Estimator::Among(TechniqueSet::of(pairs.iter().copied()));
    vec![Claim {
        what: format!("{} = techniques {pairs:?}", methods::COMBINED),
        left: side(drawn, &subject.built, Estimator::Method(methods::COMBINED)),
        right: side(drawn, &subject.built, set),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(2e-5),
        numbers: Numbers::Own,
    }]
}
