//! The list of relations. Each makes claims about a scene; where a relation says nothing about it,
//! none.

mod changed;
mod furnace;
mod methods;
mod mitsuba;
mod nudged;
mod outsider;
mod reciprocity;
mod right;
mod superposition;
mod techniques;
mod traced;
mod who;

pub use changed::Change;

use crate::relations::case::Known;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::{Built, Estimator, Trouble, Workshop};
use crate::relations::scene::DrawnScene;
use std::fmt;
use std::sync::Arc;

/// A relation that a right renderer keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// The right value, where it is known.
    Right,
    /// A light on a surface is on one side of it or on the other.
    Nudged,
    /// All methods that can see the light of a scene find the same.
    Methods,
    /// Some techniques of `bdpt` that find every path find the same.
    Techniques,
    /// The scene in another form has the same light.
    Changed(Change),
    /// The light of all lamps is the sum of that of each.
    Superposition,
    /// A lamp outside of a closed room changes nothing within.
    Outsider,
    /// A lamp and a sensor change places.
    Reciprocity,
    /// Surfaces that lose nothing, under a sky of radiance 1, are not to be seen.
    WhiteFurnace,
    /// Fronts that glow by as much as they do not reflect are not to be seen under it
    /// either.
    GlowingFurnace,
    /// Nothing under a sky of radiance 1 is brighter than the sky.
    NoGain,
    /// `trace` finds the direct light of point lights.
    Traced,
    /// Mitsuba finds the same in the same file, where it is installed.
    Mitsuba,
}

/// A scene under judgement.
#[derive(Debug)]
pub struct Subject<'a> {
    /// The scene.
    pub drawn: &'a DrawnScene,
    /// The scene, loaded.
    pub built: Arc<Built>,
    /// The right mean over the picture, where it is known.
    pub right: Option<Known>,
    /// The workshop that builds other scenes.
    pub workshop: &'a Workshop,
}

impl Relation {
    /// All of them.
    pub fn all() -> Vec<Self> {
        let alone = [
            Self::Right,
            Self::Nudged,
            Self::Methods,
            Self::Techniques,
            Self::Superposition,
            Self::Outsider,
            Self::Reciprocity,
            Self::WhiteFurnace,
            Self::GlowingFurnace,
            Self::NoGain,
        ];
        let changes = Change::ALL.map(Self::Changed);
        alone.into_iter().chain(changes).chain([Self::Traced, Self::Mitsuba]).collect()
    }

    /// Returns what it claims of this scene; `dice` choose where not all can be asked.
    ///
    /// # Errors
    /// If a scene cannot be built that should be.
    pub fn claims(self, subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
        match self {
            Self::Right => Ok(right::claims(subject)),
            Self::Nudged => nudged::claims(subject),
            Self::Methods => Ok(methods::claims(subject)),
            Self::Techniques => Ok(techniques::claims(subject, dice)),
            Self::Changed(change) => changed::claims(change, subject, dice),
            Self::Superposition => superposition::claims(subject, dice),
            Self::Outsider => outsider::claims(subject, dice),
            Self::Reciprocity => reciprocity::claims(subject, dice),
            Self::WhiteFurnace => furnace::white(subject, dice),
            Self::GlowingFurnace => furnace::glowing(subject, dice),
            Self::NoGain => furnace::no_gain(subject),
            Self::Traced => traced::claims(subject),
            Self::Mitsuba => mitsuba::claims(subject),
        }
    }

    /// Dice of its own for a scene, so that it says the same whatever else is asked.
    pub fn dice(self, seed: u64, number: u64) -> Dice {
        let place = Self::all().into_iter().position(|relation| relation == self);
        Dice::for_use(seed, number, 1 + place.unwrap_or(0) as u64)
    }

    /// The relation of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|relation| relation.to_string() == name)
    }
}

impl fmt::Display for Relation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Changed(change) => write!(f, "{change:?}"),
            Self::Right
            | Self::Nudged
            | Self::Methods
            | Self::Techniques
            | Self::Superposition
            | Self::Outsider
            | Self::Reciprocity
            | Self::WhiteFurnace
            | Self::GlowingFurnace
            | Self::NoGain
            | Self::Traced
            | Self::Mitsuba => write!(f, "{self:?}"),
        }
    }
}

impl<'a> Subject<'a> {
    /// The scene, loaded.
    ///
    /// # Errors
    /// If the library refuses it.
    pub fn new(drawn: &'a DrawnScene, workshop: &'a Workshop) -> Result<Self, Trouble> {
        Ok(Self { drawn, built: Arc::new(workshop.build(drawn)?), right: None, workshop })
    }

    fn build(&self, drawn: &DrawnScene) -> Result<Arc<Built>, Trouble> {
        self.workshop.build(drawn).map(Arc::new)
    }
}

/// A rendering of one scene by one estimator.
fn side(drawn: &DrawnScene, built: &Arc<Built>, estimator: Estimator) -> Side {
    Side::Rendered(vec![who::part(drawn, built, estimator)])
}

/// The words for an estimator.
fn name(estimator: Estimator) -> String {
    match estimator {
        Estimator::Method(method) => method.to_string(),
        Estimator::Among(_) => String::from("techniques"),
    }
}

/// Two scenes by the same estimator.
fn alike(
    scenes: [&DrawnScene; 2],
    workshop: &Workshop,
    estimator: Estimator,
    what: &str,
    law: Law,
) -> Result<Claim, Trouble> {
    let built = |scene: &DrawnScene| workshop.build(scene).map(Arc::new);
    let [left, right] = [built(scenes[0])?, built(scenes[1])?];
    Ok(Claim {
        what: format!("{what}, {}", name(estimator)),
        left: side(scenes[0], &left, estimator),
        right: side(scenes[1], &right, estimator),
        flipped: false,
        factor: 1.0,
        law,
        numbers: Numbers::of([&left, &right]),
    })
}
