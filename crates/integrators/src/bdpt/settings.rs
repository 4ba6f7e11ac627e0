//! The settings of bidirectional path tracing on a command line.

use super::{Auto, Bdpt, PathsPerPixel, Report, Techniques, Weighting};
use crate::Limits;
use traylib_math::Heuristic;

/// The settings of [`Bdpt`] as a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each stands for an option of its own")]
pub struct BdptSettings {
    /// Bounds on the length of paths.
    pub limits: Limits,
    /// The heuristic that turns densities into weights.
    pub heuristic: Heuristic,
    /// True if weights are computed by [`Weighting::DirectSum`].
    pub direct_sum: bool,
    /// True if the techniques with s ≥ 2 and t ≥ 2 are left out.
    pub no_connections: bool,
    /// True if light paths are not joined to the camera: the techniques with t = 1.
    pub no_splats: bool,
    /// Light paths of a pass, for each of its pixels.
    pub light_paths: PathsPerPixel,
    /// True if images of lamps in mirrors are neither aimed at nor, of point lights, joined.
    pub no_images: bool,
    /// The freedom of a [plan](crate::planner) that chooses for each scene which method to render
    /// by, be it another; without one all techniques take part. What is set above is left as it is
    /// then.
    pub auto: Option<Auto>,
}

impl BdptSettings {
    /// All techniques, and weights by the power heuristic.
    pub const DEFAULT: Self = Self {
        limits: Limits::NONE,
        heuristic: Heuristic::Power,
        direct_sum: false,
        no_connections: false,
        no_splats: false,
        light_paths: PathsPerPixel::ONE,
        no_images: false,
        auto: None,
    };

    /// The techniques that take part.
    pub fn techniques(self) -> Techniques {
        Techniques {
            connections: !self.no_connections,
            splats: !self.no_splats,
            mirror_connections: !self.no_images,
            ..Techniques::ALL
        }
    }

    /// The integrator, which also records this.
    pub fn integrator(self, report: Report) -> Bdpt {
        let weighting = if self.direct_sum { Weighting::DirectSum } else { Weighting::Recursive };
        let (limits, heuristic, techniques) = (self.limits, self.heuristic, self.techniques());
        let (light_paths, aims_at_images) = (self.light_paths, !self.no_images);
        Bdpt { limits, heuristic, weighting, techniques, light_paths, aims_at_images, report }
    }
}
