//! Metrics of how far a picture is from what it should be.
//!
//! A picture is a list of pixels, each with the values of N bands: three of colour, or one
//! of grey. They are linear radiance, not what a screen shows. All figures are means over
//! pixels and bands.

/// One pixel in so many is left out of the trimmed error.
const TRIMMED_ONE_IN: usize = 1000;

/// ε of relMSE for pictures of one scene: 0.01 · (mean r)². It keeps dark pixels
/// from outweighing all others; zero for a black reference.
pub fn error_floor<const N: usize>(reference: &[[f64; N]]) -> f64 {
    0.01 * mean(reference.as_flattened()).powi(2)
}

/// (x − r)²/(r² + ε) of each pixel, mean of its bands; `None` if there are not as many
/// pixels in both.
///
/// With ε = 0 a black band counts as 0 where it is black in both pictures, and as
/// infinite where only the reference is black.
pub fn relative_square_errors<const N: usize>(
    picture: &[[f64; N]],
    reference: &[[f64; N]],
    epsilon: f64,
) -> Option<Vec<f64>> {
    pixel_means(picture, reference, |x, r| share((x - r).powi(2), r * r + epsilon))
}

/// The mean of these: relMSE. Not a number without pixels, or if there are not as many in
/// both.
pub fn rel_mse<const N: usize>(picture: &[[f64; N]], reference: &[[f64; N]], epsilon: f64) -> f64 {
    let errors = relative_square_errors(picture, reference, epsilon);
    errors.map_or(f64::NAN, |errors| mean(&errors))
}

/// Returns what a reference's own noise adds to the relMSE of every picture: the mean of v/(r² +
/// ε), v being the variance of r.
pub fn own_rel_mse<const N: usize>(
    reference: &[[f64; N]],
    variances: &[[f64; N]],
    epsilon: f64,
) -> f64 {
    let bands = reference.as_flattened().iter().zip(variances.as_flattened());
    let sum: f64 = bands.map(|(r, v)| share(*v, r * r + epsilon)).sum();
    sum / reference.as_flattened().len() as f64
}

/// Measures of a picture against a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureError {
    /// Mean (x − r)².
    pub mse: f64,
    /// Mean (x − r)²/(r² + ε).
    pub rel_mse: f64,
    /// The mean without the worst pixels, one in a thousand rounded down. Much
    /// less than `rel_mse` if a few pixels make most of it.
    pub trimmed_rel_mse: f64,
    /// Mean |x − r|/(|x| + |r|), from 0 to 1; 0 where both are black.
    pub smape: f64,
    /// Mean x over mean r; 1 if both are black.
    pub mean_ratio: f64,
}

impl PictureError {
    /// Compares two pictures; `None` if there are not as many pixels in both, or none.
    ///
    /// A value that is not a number makes the figures it enters not a number.
    pub fn between<const N: usize>(
        picture: &[[f64; N]],
        reference: &[[f64; N]],
        epsilon: f64,
    ) -> Option<Self> {
        let relative = relative_square_errors(picture, reference, epsilon)?;
        if relative.is_empty() {
            return None;
        }
        let smape = |x: f64, r: f64| share((x - r).abs(), x.abs() + r.abs());
        let [light, right] = [picture, reference].map(|of| mean(of.as_flattened()));
        Some(Self {
            mse: mean(&pixel_means(picture, reference, |x, r| (x - r).powi(2))?),
            rel_mse: mean(&relative),
            trimmed_rel_mse: trimmed_mean(relative),
            smape: mean(&pixel_means(picture, reference, smape)?),
            mean_ratio: if light == right { 1.0 } else { light / right },
        })
    }
}

/// `f` of each band of two pictures, averaged over the bands of a pixel.
fn pixel_means<const N: usize>(
    picture: &[[f64; N]],
    reference: &[[f64; N]],
    f: impl Fn(f64, f64) -> f64,
) -> Option<Vec<f64>> {
    let pixel = |(x, r): (&[f64; N], &[f64; N])| {
        (0..N).map(|band| f(x[band], r[band])).sum::<f64>() / N as f64
    };
    let pairs = || picture.iter().zip(reference);
    (picture.len() == reference.len()).then(|| pairs().map(pixel).collect())
}

/// `part/whole`, and nothing of nothing is nothing.
fn share(part: f64, whole: f64) -> f64 {
    if part == 0.0 && whole == 0.0 { 0.0 } else { part / whole }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn trimmed_mean(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    mean(&values[..values.len() - values.len() / TRIMMED_ONE_IN])
}

#[cfg(test)]
mod tests;
