//! How much an error weighs where.

use super::pilot::Found;
use super::probes::Probes;
use traylib_math::Rgb;

/// Tiles along the longer side of a film.
const ALONG: u32 = 12;

/// A probe whose square is so many times that of its tile is bright by itself, not by chance.
const BRIGHT: f64 = 4.0;

/// Errors are relative to the light around them, as in relMSE: squares are divided by the
/// square of the light of the place plus a hundredth of that of the picture. The light of a
/// place is the mean of its tile, or of the probe that stands for it, where that is far
/// brighter.
pub(super) struct Tiles {
    /// One over that, for each probe.
    weights: Vec<f64>,
    grid: Grid,
}

/// Cells of a film, one for each probe.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    pub(super) columns: u32,
    pub(super) rows: u32,
    pub(super) width: u32,
    pub(super) height: u32,
}

impl Grid {
    /// The first pixel of a part of `0..whole`, of which there are `parts`.
    pub(super) fn edge(part: u32, parts: u32, whole: u32) -> u32 {
        (u64::from(part) * u64::from(whole) / u64::from(parts)) as u32
    }

    /// The part that a place lies in.
    fn part(place: u32, parts: u32, whole: u32) -> u32 {
        (((u64::from(place) + 1) * u64::from(parts) - 1) / u64::from(whole)) as u32
    }

    /// The number of the cell that a row-major pixel lies in.
    fn cell(self, pixel: u32) -> usize {
        let Self { columns, rows, width, height } = self;
        let column = Self::part(pixel % width, columns, width);
        (Self::part(pixel / width, rows, height) * columns + column) as usize
    }
}

impl Tiles {
    /// From what the pilot found in so many passes of all probes, beside `seen`, the light of
    /// lamps that the camera sees.
    pub(super) fn of(probes: &Probes<'_>, passes: u32, found: &[Found], seen: f64) -> Self {
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
        let mean = (light.iter().sum::<f64>() + seen) / all;
        let weight = |(&pixel, [a, b]): (&u32, &[f64; 2])| {
            let tile = tile(pixel);
            let around = (light[tile] / samples[tile]).powi(2);
            let bright = (a * b > BRIGHT * around).then_some(a * b);
            1.0 / (bright.unwrap_or(around) + 0.01 * mean * mean)
        };
        let weights = probes.pixels.iter().zip(&halves).map(weight).collect();
        Self { weights, grid }
    }

    /// What the square of an error at this pixel is multiplied with.
    pub(super) fn weight(&self, pixel: u32) -> f64 {
        self.weights[self.grid.cell(pixel)]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_lies_between_the_edges_of_its_part() {
        for (whole, parts) in [(10, 3), (7, 7), (640, 37), (5, 1)] {
            for place in 0..whole {
                let part = Grid::part(place, parts, whole);
                let edges = [part, part + 1].map(|part| Grid::edge(part, parts, whole));
                assert!((edges[0]..edges[1]).contains(&place), "{place} of {whole} in {parts}");
            }
        }
    }
}
