//! Groups of neighbouring values: runs of a list, square tiles of a picture.

/// The means of `batches` runs of equally many neighbouring values; what does
/// not fill a batch is left out.
///
/// # Panics
/// If there are fewer values than batches, or no batches.
pub fn batch_means(values: &[f64], batches: usize) -> Vec<f64> {
    assert!(batches > 0 && values.len() >= batches, "{} values", values.len());
    let size = values.len() / batches;
    let mean = |batch: &[f64]| batch.iter().sum::<f64>() / size as f64;
    values.chunks_exact(size).take(batches).map(mean).collect()
}

/// Sums over square tiles of `side` pixels of a picture `width` pixels wide, row by row,
/// and the pixels in each: the last tile of a row or column may be smaller.
///
/// # Panics
/// If `side` or `width` is zero.
pub fn tile_sums(values: &[f64], width: usize, side: usize) -> Vec<(f64, usize)> {
    let (columns, rows) = (width.div_ceil(side), values.len().div_ceil(width).div_ceil(side));
    let mut sums = vec![(0.0, 0); columns * rows];
    for (i, value) in values.iter().enumerate() {
        let (sum, count) = &mut sums[i / width / side * columns + i % width / side];
        *sum += value;
        *count += 1;
    }
    sums
}

/// The means over these tiles.
///
/// # Panics
/// If `side` or `width` is zero.
pub fn tile_means(values: &[f64], width: usize, side: usize) -> Vec<f64> {
    let mean = |(sum, count)| sum / count as f64;
    tile_sums(values, width, side).into_iter().map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_and_tiles_are_means() {
        assert_eq!(batch_means(&[1.0, 3.0, 5.0, 7.0, 100.0], 2), [2.0, 6.0]);
        let image = [1.0, 2.0, 3.0, 5.0, 6.0, 7.0];
        assert_eq!(tile_means(&image, 3, 2), [3.5, 5.0]);
        assert_eq!(tile_means(&image, 3, 1), image);
        assert_eq!(tile_sums(&image, 3, 2), [(14.0, 4), (10.0, 2)]);
    }

    #[test]
    fn tiles_cover_every_pixel_once() {
        // Two whole tiles and one of 1 × 8 in the first row; the same, one high.
        let pixels: Vec<usize> =
            tile_sums(&[1.0; 17 * 9], 17, 8).into_iter().map(|(_, pixels)| pixels).collect();
        assert_eq!(pixels, [64, 64, 8, 8, 8, 1]);
    }
}
