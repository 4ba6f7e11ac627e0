//! Paths with the densities of the techniques that did not find them.

use traylib_math::Rgb;

/// A path with what every technique would have had to do with it.
///
/// From many of these the noise of any subset of the techniques can be told without
/// rendering by it: see [`planner`](crate::planner).
#[derive(Clone, Debug, PartialEq)]
pub struct FoundPath {
    /// The row-major pixel that its light falls on.
    pub pixel: u32,
    /// The contribution that the technique that found it would make alone.
    pub value: Rgb,
    /// Vertices from the light of that technique.
    pub s: usize,
    /// True if it was joined to the camera (t = 1).
    pub is_splat: bool,
    /// True if it begins at a point light.
    pub is_point: bool,
    /// The s that stands for joining a point light by way of mirrors, if one does.
    pub mirror_joint: Option<usize>,
    /// The factors for s = 0 … k by which technique s finds the path more often than the one that
    /// did, in numbers of samples a pixel; zero where it cannot.
    pub ratios: Box<[f64]>,
}

impl FoundPath {
    /// Its edges.
    pub fn edges(&self) -> usize {
        self.ratios.len() - 1
    }
}
