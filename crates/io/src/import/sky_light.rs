//! The light of a sky, whatever file it comes from.

use super::scene_parts::PartSky;
use std::sync::Arc;
use traylib_materials::Texture;
use traylib_math::{Grid, Rgb};

/// A sky as the builder of a scene takes it.
#[derive(Clone, Debug)]
pub(super) struct SkyLight {
    /// W/(m²·sr), row by row from the top; one texel if it is the same everywhere.
    pub(super) radiance: Grid<Rgb>,
    /// About y, counter-clockwise seen from above.
    pub(super) turn_degrees: f32,
}

impl SkyLight {
    /// The same radiance all around.
    pub(super) fn constant(radiance: Rgb) -> Self {
        Self { radiance: Grid::filled(1, 1, radiance), turn_degrees: 0.0 }
    }

    /// Returns it as part of a scene that may be written again; `None` if it has no texels.
    pub(super) fn as_part(&self) -> Option<PartSky> {
        let radiance = Arc::new(Texture::new(self.radiance.clone())?);
        Some(PartSky { radiance, turn_degrees: self.turn_degrees })
    }

    /// Returns whether light comes from anywhere.
    pub(super) fn is_lit(&self) -> bool {
        self.radiance.values().iter().any(|light| !light.is_black())
    }
}
