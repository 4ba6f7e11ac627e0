//! One method's picture for a reference, with what is needed to judge it.

use crate::picture::{Picture, double, grey, single};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::time::Instant;
use traylib_integrators::{Control, Method, PointSet, Settings, ThreadError, render};
use traylib_math::Grid;
use traylib_scene::Scene;
use traylib_statistics::Sample;

/// Tiles across the picture.
const TILES_ACROSS: usize = 8;

/// The picture that one method makes, with its noise: one of two that become a reference.
#[derive(Clone, Debug)]
pub struct MethodReference {
    /// Mean radiance.
    pub picture: Picture,
    /// Variance of each mean.
    pub variance: Picture,
    /// The rest.
    pub numbers: Numbers,
}

impl MethodReference {
    /// Rounds to the precision in which pictures are kept.
    pub(super) fn like_stored(self) -> Self {
        let rounded = |picture: &Picture| double(&single(picture));
        Self { picture: rounded(&self.picture), variance: rounded(&self.variance), ..self }
    }
}

/// The figures of such a picture beside its pixels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Numbers {
    /// The method that made it.
    pub method: String,
    /// In how many passes.
    pub passes: u32,
    /// The seconds that it took.
    pub(super) seconds: f64,
    /// Means of tiles over passes, and the variances of these; `None` for tiles
    /// that hardly have a pixel to compare. The last entry is the whole picture.
    pub tiles: Vec<Option<(f64, f64)>>,
}

impl Numbers {
    /// A tile as a sample of passes.
    pub(super) fn tile(&self, index: usize) -> Option<Sample> {
        let (mean, variance_of_mean) = (*self.tiles.get(index)?)?;
        Some(Sample { count: self.passes as usize, mean, variance_of_mean })
    }
}

/// The request for a reference by one method.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order<'a> {
    /// The scene.
    pub(super) scene: &'a Scene,
    /// Pixels that are not compared.
    pub(super) masked: &'a Grid<bool>,
    /// The length of the rendering, in seconds.
    pub(super) seconds: f64,
    /// The seed, which is that of no run.
    pub(super) seed: u64,
    /// Threads; 0 for one a processor.
    pub(super) threads: usize,
    /// Raised when the user wants to stop.
    pub(super) stop: &'a Control,
}

impl Order<'_> {
    /// Renders; `None` if it was stopped.
    ///
    /// # Errors
    /// The system refuses threads.
    pub(super) fn render(&self, method: Method) -> Result<Option<MethodReference>, ThreadError> {
        let start = Instant::now();
        let mut tiles = Tiles::new(self.masked);
        let settings = Settings {
            spp: u32::MAX,
            seed: self.seed,
            threads: self.threads,
            // Its error is known from the spread of its passes.
            points: PointSet::Independent,
        };
        let rendering =
            render(self.scene, method.build().as_ref(), &settings, self.stop, &mut |progress| {
                tiles.add(&progress.film.mean(), progress.film.passes());
                let late = start.elapsed().as_secs_f64() >= self.seconds;
                // A variance wants two.
                let end = late && progress.film.passes() > 1;
                if end { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            })?;
        let numbers = Numbers {
            method: method.to_string(),
            passes: rendering.film.passes(),
            seconds: start.elapsed().as_secs_f64(),
            tiles: tiles.finish(rendering.film.passes()),
        };
        let picture = rendering.film.mean();
        let variance = rendering.film.variance_of_mean();
        let reference = variance.map(|variance| MethodReference { picture, variance, numbers });
        Ok(reference.filter(|_| !self.stop.is_cancelled()))
    }
}

/// Means of tiles, pass by pass.
struct Tiles {
    /// The tile of each pixel.
    of_pixel: Vec<Option<usize>>,
    /// Pixels in each, the whole picture last.
    sizes: Vec<f64>,
    /// Sums over all passes so far.
    sums: Vec<f64>,
    squares: Vec<f64>,
    /// A tile with fewer pixels says nothing.
    fewest: f64,
}

impl Tiles {
    fn new(masked: &Grid<bool>) -> Self {
        let side = masked.width().div_ceil(TILES_ACROSS).max(1);
        let columns = masked.width().div_ceil(side);
        let rows = masked.height().div_ceil(side);
        let tile = |i: usize| i / masked.width() / side * columns + i % masked.width() / side;
        let of_pixel: Vec<Option<usize>> =
            masked.values().iter().enumerate().map(|(i, out)| (!out).then(|| tile(i))).collect();
        let mut sizes = vec![0.0; columns * rows + 1];
        for &tile in of_pixel.iter().flatten() {
            sizes[tile] += 1.0;
            sizes[columns * rows] += 1.0;
        }
        let zeros = vec![0.0; sizes.len()];
        let fewest = (side * side) as f64 / 4.0;
        Self { of_pixel, sizes, sums: zeros.clone(), squares: zeros, fewest }
    }

    /// Takes in a pass, by the mean of all so far.
    fn add(&mut self, mean: &Picture, passes: u32) {
        let mut sums = vec![0.0; self.sums.len()];
        let whole = sums.len() - 1;
        for (tile, bands) in self.of_pixel.iter().zip(mean.values()) {
            if let Some(tile) = tile {
                let value = grey(bands) * f64::from(passes);
                sums[*tile] += value;
                sums[whole] += value;
            }
        }
        for ((square, before), sum) in self.squares.iter_mut().zip(&self.sums).zip(&sums) {
            *square += (sum - before).powi(2);
        }
        self.sums = sums;
    }

    fn finish(self, passes: u32) -> Vec<Option<(f64, f64)>> {
        let n = f64::from(passes);
        let tile = |i: usize| {
            let size = self.sizes[i];
            let mean = self.sums[i] / n;
            let variance = (self.squares[i] / n - mean * mean).max(0.0) / (n - 1.0);
            (size >= self.fewest.max(1.0)).then(|| (mean / size, variance / (size * size)))
        };
        (0..self.sizes.len()).map(tile).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_means_over_what_is_not_masked() {
        let mut masked = Grid::filled(16, 2, false);
        masked.values_mut()[0] = true;
        let mut tiles = Tiles::new(&masked);
        let pass = |value: f64| Grid::filled(16, 2, [value; 3]);
        tiles.add(&pass(1.0), 1);
        // The second pass is 3 everywhere, so the mean is 2.
        tiles.add(&pass(2.0), 2);
        let found = tiles.finish(2);
        assert_eq!(found.len(), 9);
        let (mean, variance) = found[0].unwrap();
        assert!((mean - 2.0).abs() < 1e-12 && (variance - 1.0).abs() < 1e-12, "{variance}");
        assert!(found[8].is_some());
    }

    #[test]
    fn a_tile_behind_a_mask_says_nothing() {
        let mut tiles = Tiles::new(&Grid::filled(8, 1, true));
        tiles.add(&Grid::filled(8, 1, [1.0; 3]), 1);
        assert!(tiles.finish(1).iter().all(Option::is_none));
    }
}
