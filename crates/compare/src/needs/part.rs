//! The parts of bidirectional tracing that can be taken away.

use std::fmt;
use traylib_integrators::{
    Bdpt, BdptSettings, Integrator, LightSampling, Limits, PathsPerPixel, PointSet, Report,
};
use traylib_scene::Scene;

/// A part of bidirectional tracing that a scene may or may not need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Walks from the camera that hit lamps count (s = 0).
    Hits,
    /// Lamps with an area are aimed at (s = 1).
    LightSamples,
    /// Two walks are connected (s and t from 2 on).
    Connections,
    /// Walks from lamps are joined to the camera (t = 1).
    Splats,
    /// Images of lamps in mirrors are aimed at and joined.
    Images,
    /// There are as many walks from lamps as from the camera, not a quarter of them.
    LightPaths,
    /// Points are quasi-random.
    EvenPoints,
    /// Paths of more edges than this.
    Longer(u32),
}

impl Part {
    /// Bidirectional tracing with all its parts.
    pub fn whole() -> Bdpt {
        BdptSettings::DEFAULT.integrator(Report::None)
    }

    /// Returns all parts that can be taken away in a scene.
    pub fn of(scene: &Scene) -> Vec<Self> {
        let has_areas = scene.lights().iter().any(|light| !light.is_point());
        let areas = [Self::Hits, Self::LightSamples].into_iter().filter(|_| has_areas);
        let rest = [
            Self::Connections,
            Self::Splats,
            Self::Images,
            Self::LightPaths,
            Self::EvenPoints,
            Self::Longer(2),
            Self::Longer(3),
            Self::Longer(4),
            Self::Longer(6),
            Self::Longer(9),
        ];
        areas.chain(rest).collect()
    }

    /// Bidirectional tracing without it.
    pub fn taken_away(self) -> Box<dyn Integrator> {
        let mut rest = Self::whole();
        match self {
            Self::Hits => rest.techniques.hits = false,
            Self::LightSamples => rest.techniques.light_samples = LightSampling::PointLights,
            Self::Connections => rest.techniques.connections = false,
            Self::Splats => rest.techniques.splats = false,
            Self::Images => {
                rest.techniques.mirror_connections = false;
                rest.aims_at_images = false;
            }
            Self::LightPaths => rest.light_paths = PathsPerPixel::of_thousandths(250),
            Self::EvenPoints => {}
            Self::Longer(edges) => {
                rest.limits = Limits { max_depth: Some(edges), ..rest.limits };
            }
        }
        Box::new(rest)
    }

    /// The points that are left.
    pub fn points(self) -> PointSet {
        match self {
            Self::EvenPoints => PointSet::Independent,
            Self::Hits
            | Self::LightSamples
            | Self::Connections
            | Self::Splats
            | Self::Images
            | Self::LightPaths
            | Self::Longer(_) => PointSet::default(),
        }
    }
}

/// Writes it as the end of "without …".
impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hits => f.write_str("hits of lamps"),
            Self::LightSamples => f.write_str("light samples"),
            Self::Connections => f.write_str("connections"),
            Self::Splats => f.write_str("splats"),
            Self::Images => f.write_str("images of lamps in mirrors"),
            Self::LightPaths => f.write_str("three of four light paths"),
            Self::EvenPoints => f.write_str("quasi-random points"),
            Self::Longer(edges) => write!(f, "paths of more than {edges} edges"),
        }
    }
}
