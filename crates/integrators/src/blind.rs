//! What an integrator cannot see.

use std::fmt;
use traylib_scene::{Light, Scene};

/// What decides which kinds of light there are in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneFacts {
    /// Some lamp has an area.
    pub area_lights: bool,
    /// Some lamp is a point.
    pub point_lights: bool,
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
    /// Light of point lamps that a mirror or glass throws onto other surfaces.
    PointLightCaustics,
    /// The same, seen by way of a mirror or glass.
    PointLightCausticsInMirrors,
    /// All that is seen in a mirror or through solid glass.
    SeenInMirrors,
}

impl SceneFacts {
    /// The facts of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            area_lights: scene.lights().iter().any(|light| !light.is_point()),
            point_lights: scene.lights().iter().any(Light::is_point),
            mirrors: scene.materials().iter().any(|material| material.model.has_delta_part()),
        }
    }

    /// What every walk from the camera misses: a point light cannot be hit after
    /// a mirror, nor aimed at from it.
    pub(crate) fn point_light_caustics(self) -> Vec<BlindSpot> {
        if self.point_lights && self.mirrors {
            vec![BlindSpot::PointLightCaustics]
        } else {
            Vec::new()
        }
    }
}

impl fmt::Display for BlindSpot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Interreflection => "light reflected more than once, mirror images included",
            Self::AreaLights => "the light that area lamps throw on other surfaces",
            Self::PointLightCaustics => {
                "light of point lamps that a mirror or glass throws onto other surfaces"
            }
            Self::PointLightCausticsInMirrors => {
                "light of point lamps that a mirror or glass throws onto surfaces seen by way of one"
            }
            Self::SeenInMirrors => "everything seen in a mirror or through solid glass",
        })
    }
}
