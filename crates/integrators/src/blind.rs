//! The kinds of light that an integrator cannot see.

use std::fmt;
use traylib_scene::{Light, Scene};

/// The facts that decide which kinds of light there are in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub struct SceneFacts {
    /// Some lamp has an area.
    pub area_lights: bool,
    /// Some lamp is a point.
    pub point_lights: bool,
    /// There is a sky.
    pub sky: bool,
    /// Some surface reflects or refracts ideally.
    pub mirrors: bool,
}

/// A kind of light that an integrator cannot produce.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlindSpot {
    /// Light reflected more than once.
    Interreflection,
    /// Light of area lamps on other surfaces.
    AreaLights,
    /// Light of the sky on surfaces.
    SkyLight,
    /// Light of point lamps that a mirror or glass throws onto other surfaces.
    PointLightCaustics,
    /// The same, seen by way of a mirror or glass.
    PointLightCausticsInMirrors,
    /// Light of point lamps thrown otherwise than by one ideal mirror that is flat or a ball, or by
    /// what of these a flat one shows.
    PointLightChains,
    /// The same, seen by way of a mirror or glass.
    PointLightChainsInMirrors,
    /// All that is seen in a mirror or through solid glass.
    SeenInMirrors,
}

impl SceneFacts {
    /// The facts of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            area_lights: scene.lights().iter().any(|light| matches!(light, Light::Area { .. })),
            point_lights: scene.lights().iter().any(Light::is_point),
            sky: scene.sky().is_some(),
            mirrors: scene.materials().iter().any(|material| material.model.has_delta_part()),
        }
    }

    /// The light that every walk from the camera misses: a point light cannot be hit after a
    /// mirror, nor aimed at from it, but [joined](crate::toolkit::light_through_mirrors) by way of
    /// some.
    pub(crate) fn point_light_caustics(self, joins_images: bool) -> Vec<BlindSpot> {
        let joined = [BlindSpot::PointLightCaustics, BlindSpot::PointLightChains];
        self.of_mirrored_points(joined[usize::from(joins_images)])
    }

    /// The same, where light walks find all but what is itself seen by way of a mirror.
    pub(crate) fn point_light_caustics_in_mirrors(self, joins_images: bool) -> Vec<BlindSpot> {
        let joined = [BlindSpot::PointLightCausticsInMirrors, BlindSpot::PointLightChainsInMirrors];
        self.of_mirrored_points(joined[usize::from(joins_images)])
    }

    fn of_mirrored_points(self, spot: BlindSpot) -> Vec<BlindSpot> {
        if self.point_lights && self.mirrors { vec![spot] } else { Vec::new() }
    }
}

impl fmt::Display for BlindSpot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Interreflection => "light reflected more than once, mirror images included",
            Self::AreaLights => "the light that area lamps throw on other surfaces",
            Self::SkyLight => "the light that the sky throws on surfaces",
            Self::PointLightCaustics => {
                "light of point lamps that a mirror or glass throws onto other surfaces"
            }
            Self::PointLightCausticsInMirrors => {
                "light of point lamps that a mirror or glass throws onto surfaces seen by way of one"
            }
            Self::PointLightChains => {
                "light of point lamps that glass, mirrors one after the other but for two of few \
                 and flat ones, or a mirror neither flat nor a ball throws onto other surfaces"
            }
            Self::PointLightChainsInMirrors => {
                "light of point lamps that glass, mirrors one after the other but for two of few \
                 and flat ones, or a mirror neither flat nor a ball throws onto surfaces seen by way of one"
            }
            Self::SeenInMirrors => "everything seen in a mirror or through solid glass",
        })
    }
}
