//! A picture on its way to the window.

use crate::view::Wanted;
use traylib_integrators::{Method, Statistics};
use traylib_math::{Grid, Rgb};

/// A picture of some passes.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    /// The camera and the method that it was to show.
    pub(crate) wanted: Wanted,
    /// The method that rendered it, if the wanted one is left to a plan the one that it chose.
    pub(crate) method: Method,
    /// The columns of the window that one of its pixels fills; one but for a preview.
    pub(crate) coarseness: u32,
    /// Light, as far as it is known.
    pub(crate) radiance: Grid<Rgb>,
    /// The pixels as the window wants them.
    pub(crate) pixels: Vec<u32>,
    /// Factor on light that was shown.
    pub(crate) exposure: f32,
    /// Samples a pixel.
    pub(crate) passes: u32,
    /// The estimated error, once there are enough passes.
    pub(crate) error: Option<f64>,
    /// All work on it so far.
    pub(crate) statistics: Statistics,
    /// Seconds since that began.
    pub(crate) seconds: f64,
}

impl Frame {
    /// Tells whether it is what somebody wants who wants this, and no preview of it.
    pub(crate) fn is_of(&self, wanted: &Wanted) -> bool {
        self.coarseness == 1 && self.wanted == *wanted
    }
}
