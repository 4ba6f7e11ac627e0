//! Lights that the camera sees.

use super::bands::bands;
use super::means::Passes;
use super::probes::Probes;
use crate::Method;

/// The light of lamps that the camera sees directly, by the rays that all methods begin with: far
/// brighter as a rule than what they light, and no matter of choice.
pub(super) struct LightsSeen {
    /// Pass by pass for each probe.
    values: Vec<[f64; 3]>,
    passes: Passes,
}

impl LightsSeen {
    pub(super) fn by(probes: &Probes<'_>, passes: Passes) -> Self {
        let lights = Method::PURE_MC.up_to(Some(1)).build();
        let Passes { points, count, .. } = passes;
        let values = probes.ask(&*lights, points, count, |_, _, probed| bands(probed.radiance));
        Self { values, passes }
    }

    /// Its passes.
    pub(super) fn passes(&self) -> Passes {
        self.passes
    }

    /// Returns the light that a probe saw in a pass.
    pub(super) fn of(&self, probe: usize, pass: u32) -> [f64; 3] {
        self.values[probe * self.passes.count as usize + pass as usize]
    }

    /// The mean over the picture and its bands.
    pub(super) fn mean(&self) -> f64 {
        let sum: f64 = self.values.iter().flatten().sum();
        sum / (3 * self.values.len()) as f64
    }

    /// The mean of a probe and its bands.
    pub(super) fn mean_of(&self, probe: usize) -> f64 {
        let count = self.passes.count as usize;
        let sum: f64 = self.values[probe * count..][..count].iter().flatten().sum();
        sum / (3 * count) as f64
    }

    /// Variance of a sample where the edges of lights cross pixels, as means of many have it;
    /// squares at the probes have these weights.
    pub(super) fn noise(&self, weights: &[f64]) -> f64 {
        self.passes.variance(&self.values, weights)
    }
}
