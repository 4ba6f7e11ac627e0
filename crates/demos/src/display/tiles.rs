//! The places of a picture that have the most of its error.

use traylib_math::Grid;

/// Some pixels of a picture side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tile {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Tiles that lie side by side along the longer side of a picture.
const ACROSS: usize = 20;

/// Smaller ones are hard to see.
const SMALLEST: usize = 8;

/// Tiles that are shown.
const SHOWN: usize = 4;

/// The tiles that add the most to the variance of a picture, and so to its estimated error, the
/// worst first: fewer where there is none.
pub(super) fn worst(variance: &Grid<[f64; 3]>) -> Vec<Tile> {
    let side = (variance.width().max(variance.height()) / ACROSS).max(SMALLEST);
    let (columns, rows) = (variance.width().div_ceil(side), variance.height().div_ceil(side));
    let mut sums = vec![0.0; columns * rows];
    for (pixel, bands) in variance.values().iter().enumerate() {
        let (x, y) = (pixel % variance.width(), pixel / variance.width());
        sums[y / side * columns + x / side] += bands.iter().sum::<f64>();
    }
    let mut numbers: Vec<usize> = (0..sums.len()).filter(|&tile| sums[tile] > 0.0).collect();
    numbers.sort_by(|&a, &b| sums[b].total_cmp(&sums[a]));
    numbers.truncate(SHOWN);
    let tile = |number: usize| {
        let (x, y) = (number % columns * side, number / columns * side);
        let (width, height) = (side.min(variance.width() - x), side.min(variance.height() - y));
        Tile { x, y, width, height }
    };
    numbers.into_iter().map(tile).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 20x11 pixels: tiles of 8x8, and what is left at the right and below.
    #[test]
    fn the_worst_tiles_come_first() {
        let noisy =
            [(2, 3, 1.0), (3, 3, 1.0), (9, 7, 3.0), (18, 10, 2.5), (0, 9, 0.1), (19, 0, 0.2)];
        let of = |pixel: usize| {
            let is_there = |&&(x, y, _): &&(usize, usize, f64)| x + 20 * y == pixel;
            [0.0, noisy.iter().find(is_there).map_or(0.0, |&(.., value)| value), 0.0]
        };
        let tile = |x, y, width, height| Tile { x, y, width, height };
        let expected = [tile(8, 0, 8, 8), tile(16, 8, 4, 3), tile(0, 0, 8, 8), tile(16, 0, 4, 8)];
        assert_eq!(worst(&Grid::from_fn(20, 11, of)), expected);
    }

    #[test]
    fn what_has_no_noise_is_not_marked() {
        assert_eq!(worst(&Grid::filled(100, 100, [0.0; 3])), []);
    }
}
