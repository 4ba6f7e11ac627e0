//! The pictures of a comparison, for the page.

use traylib_integrators::Technique;
use traylib_math::{Grid, Rgb};

/// The pictures of one scene; all of the same size but those of the techniques.
#[derive(Clone, Debug)]
pub struct ScenePictures {
    /// Factor on radiance before the tone curve.
    pub exposure: f32,
    /// The reference: the picture as it should be, in W/m²/sr.
    pub reference: Grid<Rgb>,
    /// After the longest budget, first run: in the order of the methods.
    pub methods: Vec<Grid<Rgb>>,
    /// (x − r)²/(r² + ε) of each pixel, mean of bands and of all runs after the
    /// longest budget: in the order of the methods.
    pub errors: Vec<Grid<f64>>,
    /// In the order of the outside points.
    pub outside: Vec<Grid<Rgb>>,
    /// Each technique of bdpt, raw and weighted, small; sorted by edges, then s,
    /// then raw before weighted.
    pub techniques: Vec<(Technique, Grid<Rgb>)>,
}
