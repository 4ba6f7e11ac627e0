//! What is chosen of bidirectional path tracing on a command line.

use super::{Bdpt, Report, Techniques, Weighting};
use crate::Limits;
use traylib_math::Heuristic;

/// The settings of [`Bdpt`] as a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BdptSettings {
    /// How long paths get.
    pub limits: Limits,
    /// How densities become weights.
    pub heuristic: Heuristic,
    /// Whether weights are computed by [`Weighting::DirectSum`].
    pub direct_sum: bool,
    /// Whether the techniques with s ≥ 2 and t ≥ 2 are left out.
    pub no_connections: bool,
    /// Whether images of lamps in mirrors are neither aimed at nor, of point lights, joined.
    pub no_images: bool,
}

impl BdptSettings {
    /// All techniques, and weights by the power heuristic.
    pub const DEFAULT: Self = Self {
        limits: Limits::NONE,
        heuristic: Heuristic::Power,
        direct_sum: false,
        no_connections: false,
        no_images: false,
    };

    /// The techniques that take part.
    pub fn techniques(self) -> Techniques {
        let (connections, mirror_connections) = (!self.no_connections, !self.no_images);
        Techniques { connections, mirror_connections, ..Techniques::ALL }
    }

    /// The integrator, which also records this.
    pub fn integrator(self, report: Report) -> Bdpt {
        let weighting = if self.direct_sum { Weighting::DirectSum } else { Weighting::Recursive };
        let (limits, heuristic, techniques) = (self.limits, self.heuristic, self.techniques());
        let aims_at_images = !self.no_images;
        Bdpt { limits, heuristic, weighting, techniques, aims_at_images, report }
    }
}
