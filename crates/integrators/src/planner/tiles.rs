//! The weights of errors over the picture.

use super::bands::grey;
use super::found::Found;
use super::grid::Grid;
use super::probes::Probes;
use super::seen::LightsSeen;

/// Tiles along the longer side of a film.
const ALONG: u32 = 12;

/// A probe whose square is so many times that of its tile is bright by itself, not by chance.
const BRIGHT: f64 = 4.0;

/// Errors are relative to the light around them, as in relMSE: squares are divided by the
/// square of the light of the place plus a hundredth of that of the picture. The light of a
/// place is the mean of its tile, or of the probe that stands for it, where that is far
/// brighter, and with it the lights that are seen there.
pub(super) struct Tiles {
    /// One over that, for each probe.
    weights: Vec<f64>,
    /// The term that is added to squares of light.
    dark: f64,
    grid: Grid,
}

impl Tiles {
    /// From what the pilot found in so many passes of all probes, beside the lights that
    /// the camera sees.
    pub(super) fn of(probes: &Probes<'_>, passes: u32, found: &[Found], seen: &LightsSeen) -> Self {
        let grid = probes.grid;
        let Grid { width, height, .. } = grid;
        let side = width.max(height).div_ceil(ALONG);
        let columns = width.div_ceil(side);
        let tile = |pixel: u32| (pixel / width / side * columns + pixel % width / side) as usize;
        let tiles = (columns * height.div_ceil(side)) as usize;
        let (mut light, mut samples) = (vec![0.0; tiles], vec![0.0; tiles]);
        // The light of each probe by two halves, whose product is the square of neither's noise.
        let mut halves = vec![[0.0; 2]; probes.pixels.len()];
        for Found { path, probe, pass } in found {
            light[tile(path.pixel)] += grey(path.balanced());
            if let Some(own) = path.own_light() {
                halves[*probe][(2 * pass / passes) as usize] += 2.0 * grey(own) / f64::from(passes);
            }
        }
        for &pixel in &probes.pixels {
            samples[tile(pixel)] += f64::from(passes);
        }
        let all = probes.pixels.len() as f64 * f64::from(passes);
        let mean = light.iter().sum::<f64>() / all + seen.mean();
        let dark = 0.01 * mean * mean;
        let weight = |(probe, (&pixel, [a, b])): (usize, (&u32, &[f64; 2]))| {
            let tile = tile(pixel);
            let around = (light[tile] / samples[tile]).powi(2);
            let bright = (a * b > BRIGHT * around).then_some(a * b);
            let light = bright.unwrap_or(around).sqrt() + seen.mean_of(probe);
            1.0 / (light * light + dark)
        };
        let weights = probes.pixels.iter().zip(&halves).enumerate().map(weight).collect();
        Self { weights, dark, grid }
    }

    /// A hundredth of the square of the picture's light: no place counts as darker.
    pub(super) fn dark(&self) -> f64 {
        self.dark
    }

    /// The weights of all probes.
    pub(super) fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Returns the factor of the square of an error at this pixel.
    pub(super) fn weight(&self, pixel: u32) -> f64 {
        self.weights[self.grid.cell(pixel)]
    }
}
