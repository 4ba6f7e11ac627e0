//! An exposure that suits a picture.

use traylib_math::{Grid, Rgb};

/// What is of middling brightness in a picture shows this part of white.
const MIDDLE_GREY: f64 = 0.18;

/// The factor on radiance that shows the logarithmic mean of a picture's luminance as middle grey,
/// to two digits (E. Reinhard et al., *Photographic Tone Reproduction for Digital Images*, 2002,
/// equations 1 and 2); `None` if it is black.
///
/// A few pixels that are much too bright hardly move it. Black ones do not count.
pub fn exposure_of(radiance: &Grid<Rgb>) -> Option<f32> {
    let luminance = radiance.values().iter().map(|light| f64::from(light.luminance()));
    let (mut sum, mut count) = (0.0, 0.0);
    for value in luminance.filter(|value| *value > 0.0 && value.is_finite()) {
        sum += value.ln();
        count += 1.0;
    }
    (count > 0.0).then(|| two_digits(MIDDLE_GREY / (sum / count).exp())).flatten()
}

/// A number that people can write; `None` if it is not one of single precision above zero.
pub(crate) fn two_digits(exposure: f64) -> Option<f32> {
    if !(exposure > 0.0 && exposure.is_finite()) {
        return None;
    }
    let digits = 10_f64.powi(1 - exposure.log10().floor() as i32);
    let rounded = ((exposure * digits).round() / digits) as f32;
    (rounded > 0.0 && rounded.is_finite()).then_some(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(grey: &[f32]) -> Option<f32> {
        let pixels = grey.iter().map(|&value| Rgb::splat(value)).collect();
        exposure_of(&Grid::from_values(grey.len(), 1, pixels).unwrap())
    }

    #[test]
    fn the_middle_becomes_grey() {
        assert_eq!(of(&[0.18; 3]), Some(1.0));
        // Halfway from 0.1 to 0.4 by factors is 0.2.
        assert_eq!(of(&[0.1, 0.4]), Some(0.9));
        assert_eq!(of(&[300.0, 0.0, 300.0]), Some(0.0006));
        assert_eq!(of(&[f32::NAN, 0.18, f32::INFINITY]), Some(1.0));
    }

    #[test]
    fn black_has_none() {
        assert_eq!(of(&[0.0, -1.0]), None);
        assert_eq!(of(&[f32::from_bits(1)]), None);
    }

    #[test]
    fn two_digits_are_kept() {
        assert_eq!(two_digits(0.012_345), Some(0.012));
        assert_eq!(two_digits(98_765.0), Some(99_000.0));
        assert_eq!([two_digits(0.0), two_digits(f64::NAN), two_digits(1e60)], [None; 3]);
    }
}
