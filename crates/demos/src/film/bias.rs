//! Tests whether one picture is brighter than another, or only noisier.

use traylib_math::Grid;
use traylib_statistics::{Sample, tile_sums};

/// Side of a block in pixels.
pub(super) const SIDE: usize = 8;

/// The difference of two pictures' light, blocks of pixels taken as draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BlockTest {
    /// Standard errors that the mean difference is from zero; `None` where all
    /// blocks differ alike, or there is but one.
    pub z: Option<f64>,
    /// Blocks.
    pub blocks: usize,
}

/// Sums `differences` over blocks of [`SIDE`] × [`SIDE`] pixels, smaller at the right
/// and the lower edge, and holds the mean of the sums against their spread.
///
/// Blocks are taken as independent: right for pixels with noise of their own, too
/// sure where one light path adds to many pixels.
pub(super) fn block_test(differences: &Grid<f64>) -> BlockTest {
    let blocks = tile_sums(differences.values(), differences.width(), SIDE);
    let sums: Vec<f64> = blocks.into_iter().map(|(sum, _)| sum).collect();
    BlockTest { z: Sample::of(&sums).z_score(), blocks: sums.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_every_pixel_once() {
        // Two whole blocks and two of 1 × 8 in the first row; the same, one high.
        let test = block_test(&Grid::filled(17, 9, 1.0));
        assert_eq!(test.blocks, 6);
        // Sums 64, 64, 8, 8, 8, 1: mean 25.5, squares off it sum up to 4483.5.
        let expected = 25.5 / (4483.5_f64 / 30.0).sqrt();
        assert!((test.z.unwrap() - expected).abs() < 1e-12, "{test:?}");
    }

    #[test]
    fn the_sign_is_that_of_the_difference_and_equal_blocks_say_nothing() {
        let mut differences = Grid::filled(32, 8, -1.0);
        assert_eq!(block_test(&differences), BlockTest { z: None, blocks: 4 });
        differences.values_mut()[0] = 1.0;
        assert!(block_test(&differences).z.unwrap() < -100.0);
        assert_eq!(block_test(&Grid::filled(3, 3, 1.0)), BlockTest { z: None, blocks: 1 });
    }
}
