//! How far a picture is from what it should be.
//!
//! Pictures are linear radiance in W/m²/sr, not what a screen shows. All figures
//! are means over pixels and bands.

use traylib_math::Grid;

/// One pixel in so many is left out of the trimmed error.
const TRIMMED_ONE_IN: usize = 1000;

/// ε of relMSE for pictures of one scene: 0.01 · (mean r)². It keeps dark pixels
/// from outweighing all others; zero for a black reference.
pub fn error_floor(reference: &Grid<[f64; 3]>) -> f64 {
    0.01 * mean_light(reference).powi(2)
}

/// (x − r)²/(r² + ε) of each pixel, mean of its bands; `None` if sizes differ.
///
/// With ε = 0 a black band counts as 0 where it is black in both pictures, and as
/// infinite where only the reference is black.
pub fn relative_square_errors(
    picture: &Grid<[f64; 3]>,
    reference: &Grid<[f64; 3]>,
    epsilon: f64,
) -> Option<Grid<f64>> {
    pixel_means(picture, reference, |x, r| share((x - r).powi(2), r * r + epsilon))
}

/// Measures of a picture against a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureError {
    /// Mean (x − r)², in (W/m²/sr)².
    pub mse: f64,
    /// Mean (x − r)²/(r² + ε).
    pub rel_mse: f64,
    /// The same without the worst pixels, one in a thousand rounded down. Much
    /// less than `rel_mse` if a few pixels make most of it.
    pub trimmed_rel_mse: f64,
    /// Mean |x − r|/(|x| + |r|), from 0 to 1; 0 where both are black.
    pub smape: f64,
    /// Mean x over mean r; 1 if both are black.
    pub mean_ratio: f64,
}

impl PictureError {
    /// Compares two pictures; `None` if sizes differ or there are no pixels.
    ///
    /// A value that is not a number makes the figures it enters not a number.
    pub fn between(
        picture: &Grid<[f64; 3]>,
        reference: &Grid<[f64; 3]>,
        epsilon: f64,
    ) -> Option<Self> {
        let relative = relative_square_errors(picture, reference, epsilon)?;
        if relative.values().is_empty() {
            return None;
        }
        let smape = |x: f64, r: f64| share((x - r).abs(), x.abs() + r.abs());
        let (light, right) = (mean_light(picture), mean_light(reference));
        Some(Self {
            mse: mean(pixel_means(picture, reference, |x, r| (x - r).powi(2))?.values()),
            rel_mse: mean(relative.values()),
            trimmed_rel_mse: trimmed_mean(relative.values()),
            smape: mean(pixel_means(picture, reference, smape)?.values()),
            mean_ratio: if light == right { 1.0 } else { light / right },
        })
    }
}

/// `f` of each band of two pictures, averaged over the bands of a pixel.
fn pixel_means(
    picture: &Grid<[f64; 3]>,
    reference: &Grid<[f64; 3]>,
    f: impl Fn(f64, f64) -> f64,
) -> Option<Grid<f64>> {
    let (width, height) = (reference.width(), reference.height());
    if (picture.width(), picture.height()) != (width, height) {
        return None;
    }
    let pixel = |(x, r): (&[f64; 3], &[f64; 3])| (0..3).map(|b| f(x[b], r[b])).sum::<f64>() / 3.0;
    let means = picture.values().iter().zip(reference.values()).map(pixel);
    Grid::from_values(width, height, means.collect())
}

/// `part/whole`, and nothing of nothing is nothing.
fn share(part: f64, whole: f64) -> f64 {
    if part == 0.0 && whole == 0.0 { 0.0 } else { part / whole }
}

fn mean_light(picture: &Grid<[f64; 3]>) -> f64 {
    mean(picture.values().as_flattened())
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn trimmed_mean(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    mean(&sorted[..values.len() - values.len() / TRIMMED_ONE_IN])
}

#[cfg(test)]
mod tests;
