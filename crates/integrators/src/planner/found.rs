//! Paths of the pilot.

use crate::FoundPath;
use traylib_math::Rgb;

/// A path and who found it when.
pub(super) struct Found {
    pub(super) path: FoundPath,
    pub(super) probe: usize,
    pub(super) pass: u32,
}

impl FoundPath {
    /// Its light by the balance heuristic over all techniques, of which each path is an
    /// unbiased sample.
    pub(super) fn balanced(&self) -> Rgb {
        self.value * (1.0 / self.ratios.iter().sum::<f64>()) as f32
    }

    /// The same over those that begin at the camera, if it was found by one of them: light of
    /// its own pixel.
    pub(super) fn own_light(&self) -> Option<Rgb> {
        (!self.is_splat).then(|| self.value * (1.0 / self.found_from_camera()) as f32)
    }

    /// Returns how many times as often techniques from the camera find it, all together, as the one
    /// that did.
    pub(super) fn found_from_camera(&self) -> f64 {
        // The last, t = 1, begins at no camera.
        self.ratios[..self.edges()].iter().sum()
    }
}
