//! One picture against another, in numbers.

use super::bias::{BlockTest, block_test};
use traylib_math::{Grid, Rgb};
use traylib_statistics::{PictureError, error_floor, relative_square_errors};

type Light = [f64; 3];

/// The difference of a picture from a reference.
///
/// Pixels that are not finite in one of the two are left out of every figure.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Comparison {
    /// Columns and rows.
    pub size: [usize; 2],
    /// ε of relMSE.
    pub epsilon: f64,
    /// Measures of difference.
    pub error: PictureError,
    /// The test of whether the means differ by more than noise.
    pub bias: BlockTest,
    /// The pixel with the largest relative square error; `None` if none has any.
    pub worst: Option<Worst>,
    /// Pixels left out, and where the first is.
    pub left_out: LeftOut,
}

/// A pixel that is far off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Worst {
    /// Column and row.
    pub at: [usize; 2],
    /// (x − r)²/(r² + ε), mean of the bands.
    pub error: f64,
    /// x.
    pub picture: Light,
    /// r.
    pub reference: Light,
}

/// Pixels that are not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct LeftOut {
    /// In the picture, in the reference.
    pub pixels: [usize; 2],
    /// Column and row of the first in either.
    pub first: Option<[usize; 2]>,
}

impl Comparison {
    /// Compares two pictures of one size; `None` if no pixel is finite in both.
    pub(super) fn of(
        picture: &Grid<Rgb>,
        reference: &Grid<Rgb>,
        epsilon: Option<f64>,
    ) -> Option<Self> {
        let pixels = [picture, reference].map(|grid| grid.map(light));
        let is_sound = |index: &usize| pixels.iter().all(|grid| is_finite(&grid.values()[*index]));
        let kept: Vec<usize> = (0..pixels[0].values().len()).filter(is_sound).collect();
        let [x, r] = pixels.each_ref().map(|grid| pick(grid, &kept));
        let epsilon = epsilon.unwrap_or_else(|| error_floor(&r));
        let errors = relative_square_errors(&x, &r, epsilon)?;
        let worst = greatest(&errors).map(|i| Worst {
            at: place(picture.width(), kept[i]),
            error: errors[i],
            picture: x[i],
            reference: r[i],
        });
        Some(Self {
            size: [picture.width(), picture.height()],
            epsilon,
            error: PictureError::between(&x, &r, epsilon)?,
            bias: block_test(&differences(&pixels)),
            worst,
            left_out: left_out(&pixels),
        })
    }
}

fn light(pixel: &Rgb) -> Light {
    pixel.to_array().map(f64::from)
}

fn is_finite(light: &Light) -> bool {
    light.iter().all(|band| band.is_finite())
}

/// Some of the pixels: the figures do not ask where a pixel stands.
fn pick(grid: &Grid<Light>, kept: &[usize]) -> Vec<Light> {
    kept.iter().map(|&index| grid.values()[index]).collect()
}

/// x − r, sum of the bands; nothing where a pixel is left out.
fn differences([picture, reference]: &[Grid<Light>; 2]) -> Grid<f64> {
    let pairs = picture.values().iter().zip(reference.values());
    let sum = |(x, r): (&Light, &Light)| (0..3).map(|band| x[band] - r[band]).sum::<f64>();
    let values = pairs.map(sum).map(|sum| if sum.is_finite() { sum } else { 0.0 });
    Grid::from_values(picture.width(), picture.height(), values.collect()).expect("one a pixel")
}

/// The first of the largest values; `None` if none is above zero.
fn greatest(values: &[f64]) -> Option<usize> {
    let positive = (0..values.len()).filter(|&i| values[i] > 0.0);
    positive.reduce(|best, i| if values[i] > values[best] { i } else { best })
}

fn left_out(pixels: &[Grid<Light>; 2]) -> LeftOut {
    let bad = |grid: &Grid<Light>| grid.values().iter().filter(|light| !is_finite(light)).count();
    let firsts = pixels.iter().filter_map(|grid| grid.values().iter().position(|l| !is_finite(l)));
    LeftOut {
        pixels: pixels.each_ref().map(bad),
        first: firsts.min().map(|index| place(pixels[0].width(), index)),
    }
}

fn place(width: usize, index: usize) -> [usize; 2] {
    [index % width, index / width]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(values: [f32; 4]) -> Grid<Rgb> {
        let values = values.map(|value| Rgb::new(value, value, value));
        Grid::from_values(2, 2, values.to_vec()).unwrap()
    }

    #[test]
    fn pixels_that_are_not_finite_are_left_out_and_counted() {
        let x = picture([1.0, f32::NAN, 3.0, f32::INFINITY]);
        let r = picture([1.0, 1.0, 1.0, f32::NAN]);
        let found = Comparison::of(&x, &r, None).unwrap();
        assert_eq!(found.left_out, LeftOut { pixels: [2, 1], first: Some([1, 0]) });
        assert_eq!((found.epsilon, found.error.mse, found.error.mean_ratio), (0.01, 2.0, 2.0));
        let worst = found.worst.unwrap();
        assert_eq!((worst.at, worst.picture, worst.reference), ([0, 1], [3.0; 3], [1.0; 3]));
        assert_eq!(Comparison::of(&picture([f32::NAN; 4]), &r, None), None);
    }

    #[test]
    fn equal_pictures_have_no_worst_pixel() {
        let found = Comparison::of(&picture([1.0; 4]), &picture([1.0; 4]), Some(0.5)).unwrap();
        assert_eq!((found.worst, found.epsilon, found.error.rel_mse), (None, 0.5, 0.0));
        assert_eq!(found.left_out, LeftOut::default());
    }
}
