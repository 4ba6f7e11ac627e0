//! How much an error weighs where.

use super::probes::Probes;
use traylib_math::Rgb;

/// Tiles along the longer side of a film.
const ALONG: u32 = 12;

/// Errors are relative to the light around them, as in relMSE: squares are divided by the
/// square of the tile's mean plus a hundredth of that of the picture.
pub(super) struct Tiles {
    /// One over that, of each tile.
    weights: Vec<f64>,
    columns: u32,
    side: u32,
    width: u32,
}

impl Tiles {
    /// From the light that was found on pixels, the mean over all probes being the sum of all
    /// over the number of `samples`.
    pub(super) fn of(
        probes: &Probes<'_>,
        samples: f64,
        light: impl Iterator<Item = (u32, Rgb)>,
    ) -> Self {
        let (width, height) = (probes.scene.camera().width(), probes.scene.camera().height());
        let side = width.max(height).div_ceil(ALONG);
        let (columns, rows) = (width.div_ceil(side), height.div_ceil(side));
        let mut tiles = Self { weights: Vec::new(), columns, side, width };
        let mut sums = vec![0.0; (columns * rows) as usize];
        for (pixel, radiance) in light {
            sums[tiles.tile(pixel)] += grey(radiance);
        }
        // A tile has as many samples as its share of the probes.
        let mut counts = vec![0.0; sums.len()];
        let share = samples / probes.pixels.len() as f64;
        for &pixel in &probes.pixels {
            counts[tiles.tile(pixel)] += share;
        }
        let mean = sums.iter().sum::<f64>() / samples;
        let weight = |(sum, count): (&f64, &f64)| {
            let own = if *count > 0.0 { sum / count } else { 0.0 };
            1.0 / (own * own + 0.01 * mean * mean)
        };
        tiles.weights = sums.iter().zip(&counts).map(weight).collect();
        tiles
    }

    /// What the square of an error at this pixel is multiplied with.
    pub(super) fn weight(&self, pixel: u32) -> f64 {
        self.weights[self.tile(pixel)]
    }

    fn tile(&self, pixel: u32) -> usize {
        let (x, y) = (pixel % self.width, pixel / self.width);
        (y / self.side * self.columns + x / self.side) as usize
    }
}

/// The mean of the bands.
pub(super) fn grey(light: Rgb) -> f64 {
    f64::from(light.r + light.g + light.b) / 3.0
}

/// The mean of the products of the bands.
pub(super) fn product(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / 3.0
}

/// The bands in double precision.
pub(super) fn bands(light: Rgb) -> [f64; 3] {
    light.to_array().map(f64::from)
}
