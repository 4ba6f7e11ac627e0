//! One pass over the picture.

use std::collections::BTreeMap;
use traylib_math::{Grid, Rgb};

/// One pass over the whole picture: an estimate of the radiance of each pixel,
/// from its own camera sample and from whatever light paths splatted into it.
#[derive(Clone, Debug)]
pub struct PassImage {
    pub(super) light: Grid<[f64; 3]>,
    /// Further pictures of the same size, by number; one that is missing is black.
    pub(super) layers: BTreeMap<u16, Grid<[f64; 3]>>,
}

impl PassImage {
    /// A black pass.
    pub fn new(width: u32, height: u32) -> Self {
        Self { light: black(width as usize, height as usize), layers: BTreeMap::new() }
    }

    /// Adds radiance to the pixel with this row-major index.
    pub fn add(&mut self, pixel: u32, radiance: Rgb) {
        add(&mut self.light, pixel, radiance);
    }

    /// Adds radiance to a pixel of a further picture.
    pub fn add_to_layer(&mut self, layer: u16, pixel: u32, radiance: Rgb) {
        let (width, height) = (self.light.width(), self.light.height());
        add(self.layers.entry(layer).or_insert_with(|| black(width, height)), pixel, radiance);
    }
}

/// A picture without light.
pub(super) fn black(width: usize, height: usize) -> Grid<[f64; 3]> {
    Grid::filled(width, height, [0.0; 3])
}

fn add(image: &mut Grid<[f64; 3]>, pixel: u32, radiance: Rgb) {
    let sum = &mut image.values_mut()[pixel as usize];
    for (sum, band) in sum.iter_mut().zip(radiance.to_array()) {
        *sum += f64::from(band);
    }
}
