//! Light as numbers.

use traylib_math::Rgb;

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
