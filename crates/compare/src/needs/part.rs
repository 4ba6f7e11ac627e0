//! The parts of bidirectional tracing and of a scene that can be taken away.

use std::fmt;
use traylib_integrators::{
    Bdpt, BdptSettings, LightSampling, Limits, PathsPerPixel, PointSet, Report,
};
use traylib_scene::{Detail, Error, Scene};

/// A part of bidirectional tracing that a scene may or may not need, or of the scene that its
/// picture may or may not show.
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
    /// Surfaces have this detail.
    Detail(Detail),
    /// Paths of more edges than this.
    Longer(u32),
}

/// What renders, and of what.
#[derive(Debug)]
pub struct Rest {
    /// The scene.
    pub scene: Scene,
    /// Bidirectional tracing.
    pub integrator: Bdpt,
    /// The source of its numbers.
    pub points: PointSet,
}

impl Rest {
    /// With all parts.
    pub fn whole(scene: &Scene) -> Self {
        let integrator = BdptSettings::DEFAULT.integrator(Report::None);
        Self { scene: scene.clone(), integrator, points: PointSet::default() }
    }
}

impl Part {
    /// Returns all parts that can be taken away in a scene.
    pub fn of(scene: &Scene) -> Vec<Self> {
        let has_areas = scene.lights().iter().any(|light| !light.is_point());
        let areas = [Self::Hits, Self::LightSamples].into_iter().filter(|_| has_areas);
        let methods =
            [Self::Connections, Self::Splats, Self::Images, Self::LightPaths, Self::EvenPoints];
        let details = Detail::ALL.into_iter().filter(|&detail| scene.has(detail));
        let lengths = [2, 3, 4, 6, 9].map(Self::Longer);
        areas.chain(methods).chain(details.map(Self::Detail)).chain(lengths).collect()
    }

    /// Returns what is left of the whole on a scene without this part.
    ///
    /// # Errors
    /// Those of [`Scene::without`].
    pub fn taken_from(self, scene: &Scene) -> Result<Rest, Error> {
        let mut rest = Rest::whole(scene);
        let bdpt = &mut rest.integrator;
        match self {
            Self::Hits => bdpt.techniques.hits = false,
            Self::LightSamples => bdpt.techniques.light_samples = LightSampling::PointLights,
            Self::Connections => bdpt.techniques.connections = false,
            Self::Splats => bdpt.techniques.splats = false,
            Self::Images => {
                bdpt.techniques.mirror_connections = false;
                bdpt.aims_at_images = false;
            }
            Self::LightPaths => bdpt.light_paths = PathsPerPixel::of_thousandths(250),
            Self::EvenPoints => rest.points = PointSet::Independent,
            Self::Detail(detail) => rest.scene = scene.without(detail)?,
            Self::Longer(edges) => {
                bdpt.limits = Limits { max_depth: Some(edges), ..bdpt.limits };
            }
        }
        Ok(rest)
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
            Self::Detail(Detail::Pictures) => f.write_str("textures"),
            Self::Detail(Detail::Bumps) => f.write_str("bump maps"),
            Self::Detail(Detail::SmoothNormals) => f.write_str("smooth normals"),
            Self::Longer(edges) => write!(f, "paths of more than {edges} edges"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_io::load_scene;

    fn details(scene: &str) -> Vec<String> {
        let parts = Part::of(&load_scene(scene).unwrap().scene).into_iter();
        let details = parts.filter(|part| match part {
            Part::Detail(_) => true,
            Part::Hits
            | Part::LightSamples
            | Part::Connections
            | Part::Splats
            | Part::Images
            | Part::LightPaths
            | Part::EvenPoints
            | Part::Longer(_) => false,
        });
        details.map(|part| part.to_string()).collect()
    }

    #[test]
    fn details_are_taken_only_from_scenes_that_have_them() {
        assert_eq!(details("bump"), ["textures", "bump maps"]);
        assert_eq!(details("cornell"), [""; 0]);
        assert_eq!(details("plates"), [""; 0]);
    }

    #[test]
    fn a_detail_leaves_the_method_and_a_technique_the_scene() {
        let scene = load_scene("bump").unwrap().scene;
        let whole = Rest::whole(&scene);
        let flat = Part::Detail(Detail::Bumps).taken_from(&scene).unwrap();
        assert!(scene.has(Detail::Bumps) && !flat.scene.has(Detail::Bumps));
        assert!(flat.scene.has(Detail::Pictures));
        assert_eq!(format!("{:?}", flat.integrator), format!("{:?}", whole.integrator));
        let blind = Part::Hits.taken_from(&scene).unwrap();
        assert_eq!(blind.scene.content_hash(), scene.content_hash());
        assert!(whole.integrator.techniques.hits && !blind.integrator.techniques.hits);
    }
}
