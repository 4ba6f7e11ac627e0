//! The measurements by which a method was chosen.

use super::forecast::{Kind, Share};
use crate::{BlindSpot, Method};

/// A method that could have been chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// The method.
    pub method: Method,
    /// Variance of one sample a pixel over the squares of the light around it, as the pilot
    /// has it.
    pub forecast: f64,
    /// The same as a trial had it, where there was one.
    pub tried: Option<f64>,
    /// Nanoseconds of a sample by the table of prices.
    pub cost: f64,
}

impl Choice {
    /// The same as [`expected`](Self::expected) by its trial; infinite if it had none.
    pub fn measured(&self) -> f64 {
        self.tried.map_or(f64::INFINITY, |variance| variance * self.cost)
    }

    /// Returns the effort to reach an error, but for a factor that all have in common: variance
    /// times cost, by the forecast.
    pub fn expected(&self) -> f64 {
        self.forecast * self.cost
    }
}

/// The measurements that decided a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// All that was chosen from: first those that were tried, each group with the best first.
    pub choices: Vec<Choice>,
    /// The methods that are blind to light of such scenes, and the light of each.
    pub blind: Vec<(Method, BlindSpot)>,
    /// The shares of the chosen method's techniques, of those that hold anything.
    pub techniques: Vec<TechniqueShare>,
    /// The part of all light on paths with more than 0, 1, 2 … edges.
    pub beyond: Vec<f64>,
    /// Samples that pilot and trials took, as a part of those of the picture.
    pub spent: f64,
}

/// The share of the techniques of a kind in a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TechniqueShare {
    /// The kind.
    pub kind: Kind,
    /// Its part of the picture's light.
    pub light: f64,
    /// Its part of the squares of what samples add.
    pub squares: f64,
}

impl TechniqueShare {
    pub(super) fn list(shares: [Share; Kind::ALL.len()]) -> Vec<Self> {
        let shares = Kind::ALL.into_iter().zip(shares).filter(|(_, share)| share.light > 0.0);
        shares.map(|(kind, Share { light, squares })| Self { kind, light, squares }).collect()
    }
}
