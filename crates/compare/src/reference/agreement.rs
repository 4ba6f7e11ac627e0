//! Tests whether two methods render the same picture.

use super::method_reference::Numbers;
use crate::results::ReferenceAgreement;
use traylib_statistics::{ratio_of_means, sidak, welch};

/// False alarms among all tiles of a pair.
const LEVEL: f64 = 1e-3;

/// Compares two; `masked` is the share of pixels that were left out.
pub(super) fn agreement(a: &Numbers, b: &Numbers, masked: f64) -> ReferenceAgreement {
    let last = a.tiles.len() - 1;
    let tiles: Vec<f64> = (0..last).filter_map(|i| Some(welch(&a.tile(i)?, &b.tile(i)?))).collect();
    let level = sidak(LEVEL, tiles.len());
    ReferenceAgreement {
        methods: [a.method.clone(), b.method.clone()],
        mean_ratio: a.tile(last).zip(b.tile(last)).and_then(|(a, b)| ratio_of_means(&a, &b)),
        tiles: tiles.len() as u32,
        refused: tiles.iter().filter(|p| **p < level).count() as u32,
        masked,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(tiles: &[f64], variance: f64) -> Numbers {
        let whole = tiles.iter().sum::<f64>() / tiles.len() as f64;
        let tile = |mean: f64| Some((mean, variance));
        let tiles = tiles.iter().chain([&whole]).map(|mean| tile(*mean)).collect();
        Numbers { method: "m".into(), passes: 1000, seconds: 1.0, tiles }
    }

    #[test]
    fn black_pictures_agree() {
        let found = agreement(&numbers(&[0.0; 4], 0.0), &numbers(&[0.0; 4], 0.0), 0.0);
        assert_eq!((found.mean_ratio, found.refused), (None, 0));
    }

    #[test]
    fn a_wrong_tile_is_refused_and_noise_is_not() {
        let right = numbers(&[1.0, 2.0, 3.0, 4.0], 1e-4);
        let near = numbers(&[1.01, 1.99, 3.0, 4.01], 1e-4);
        let wrong = numbers(&[1.0, 2.2, 3.0, 4.0], 1e-4);
        assert_eq!(agreement(&right, &near, 0.0).refused, 0);
        let found = agreement(&right, &wrong, 0.25);
        assert_eq!((found.tiles, found.refused, found.masked), (4, 1, 0.25));
        let ratio = found.mean_ratio.unwrap();
        assert!(ratio.low < ratio.value && ratio.value < 1.0);
    }
}
