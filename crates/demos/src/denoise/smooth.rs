//! Means over squares of pixels.

use std::ops::{Add, Mul, Sub};
use traylib_math::Grid;

/// Values that can be summed up and divided.
pub(super) trait Value: Copy + Default + Add<Output = Self> + Sub<Output = Self> {
    /// A part of it.
    fn times(self, factor: f32) -> Self;
}

impl<T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f32, Output = T>> Value for T {
    fn times(self, factor: f32) -> Self {
        self * factor
    }
}

/// Returns each pixel's mean over the square of pixels as far as `radius` from it; beyond the
/// picture its edges go on.
pub(super) fn mean<T: Value>(picture: &Grid<T>, radius: usize) -> Grid<T> {
    let (width, height) = (picture.width(), picture.height());
    let mut values = picture.values().to_vec();
    for row in values.chunks_exact_mut(width.max(1)) {
        along(row, radius);
    }
    let mut column = Vec::with_capacity(height);
    for x in 0..width {
        column.clear();
        column.extend(values.iter().skip(x).step_by(width).copied());
        along(&mut column, radius);
        for (y, value) in column.iter().enumerate() {
            values[y * width + x] = *value;
        }
    }
    Grid::from_fn(width, height, |i| values[i])
}

/// The same along a line.
fn along<T: Value>(line: &mut [T], radius: usize) {
    let Some(last) = line.len().checked_sub(1) else { return };
    let factor = 1.0 / (2 * radius + 1) as f32;
    let before = line.to_vec();
    for (i, value) in line.iter_mut().enumerate() {
        // Sum by sum: a running one would carry the rounding of a bright pixel along.
        let at = |offset: usize| before[(i + offset).saturating_sub(radius).min(last)];
        let sum = (0..=2 * radius).map(at).fold(T::default(), Add::add);
        *value = sum.times(factor);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_spread_over_its_square() {
        let mut picture = Grid::filled(7, 5, 0.0);
        picture.values_mut()[2 * 7 + 3] = 9.0;
        let mean = mean(&picture, 1);
        let inside = |i: usize| (2..=4).contains(&(i % 7)) && (1..=3).contains(&(i / 7));
        for (i, value) in mean.values().iter().enumerate() {
            assert!((value - f32::from(u8::from(inside(i)))).abs() < 1e-6, "{i}: {value}");
        }
    }

    #[test]
    fn edges_go_on() {
        let picture = Grid::from_fn(3, 1, |x| x as f32);
        let sums = mean(&picture, 1).map(|mean| (3.0 * mean).round());
        assert_eq!(sums.values(), [1.0, 3.0, 5.0]);
        assert_eq!(mean(&Grid::filled(1, 1, 2.5), 4).values(), [2.5]);
    }
}
