//! Radiance pictures: linear light, eight bits a band and one exponent a pixel.

use super::Cause;
use image::codecs::hdr::HdrEncoder;
use traylib_math::{Grid, Rgb};

/// Less than this in all bands is black. The format goes a little further down, the
/// encoder's arithmetic does not.
const DIMMEST: f32 = 1e-36;

/// The largest value there is, 255 · 2¹¹⁹.
const BRIGHTEST: f32 = 255.0 * (1_u128 << 119) as f32;

pub(super) fn encode(radiance: &Grid<Rgb>) -> Result<Vec<u8>, Cause> {
    let (width, height) = (radiance.width(), radiance.height());
    if width == 32_768 {
        return Err("rows of 32768 pixels are written so that no program reads them".into());
    }
    let pixels: Vec<_> =
        radiance.values().iter().map(|&light| image::Rgb(nearest(light))).collect();
    let mut bytes = Vec::new();
    HdrEncoder::new(&mut bytes).encode(&pixels, width, height)?;
    Ok(bytes)
}

/// Tells whether a band is not rounded but changed.
pub(super) fn is_lost(band: f32) -> bool {
    !(0.0..=BRIGHTEST).contains(&band)
}

/// The nearest light that the format has. The encoder itself cuts off, which would
/// darken pictures, and expects values that are finite and not tiny. What is
/// negative or not a number becomes black.
fn nearest(light: Rgb) -> [f32; 3] {
    let bands = light.to_array().map(|band| if band > 0.0 { band.min(BRIGHTEST) } else { 0.0 });
    let brightest = bands.into_iter().fold(0.0, f32::max);
    if brightest < DIMMEST {
        return [0.0; 3];
    }
    // 2^e is above the brightest band, and 2^(e-1) is not.
    let e = (brightest.to_bits() >> 23).cast_signed() - 126;
    let steps = 2.0_f32.powi(8 - e);
    bands.map(|band| (band * steps).round() / steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_is_rounded_to_eight_bits_below_its_brightest_band() {
        assert_eq!(nearest(Rgb::new(1.0, 0.5, 0.002)), [1.0, 0.5, 0.0]);
        assert_eq!(nearest(Rgb::new(1.0, 0.006, 0.004)), [1.0, 1.0 / 128.0, 1.0 / 128.0]);
        assert_eq!(nearest(Rgb::new(0.999, 0.1, 0.0)), [1.0, 26.0 / 256.0, 0.0]);
    }

    #[test]
    fn what_cannot_be_stored_is_the_nearest_that_can() {
        assert_eq!(nearest(Rgb::new(f32::NAN, -1.0, 1e-40)), [0.0; 3]);
        assert_eq!(nearest(Rgb::new(f32::INFINITY, f32::MAX, 1.0)), [BRIGHTEST, BRIGHTEST, 0.0]);
        let dim = nearest(Rgb::new(1e-36, 3e-37, 0.0));
        assert!((dim[0] - 1e-36).abs() < 3e-39 && (dim[1] - 3e-37).abs() < 3e-39, "{dim:?}");
    }
}
