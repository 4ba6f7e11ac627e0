//! PNG, 8 bits a channel.

use crate::srgb;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};
use std::error::Error;
use traylib_math::{Grid, Rgb};

type Cause = Box<dyn Error + Send + Sync>;

pub(super) fn encode(radiance: &Grid<Rgb>, exposure: f32) -> Result<Vec<u8>, Cause> {
    let pixels: Vec<u8> =
        radiance.values().iter().flat_map(|&light| screen_rgb(light, exposure)).collect();
    let (width, height) = (u32::try_from(radiance.width())?, u32::try_from(radiance.height())?);
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes).write_image(&pixels, width, height, ExtendedColorType::Rgb8)?;
    Ok(bytes)
}

/// Red, green and blue as a screen shows radiance: times the exposure, clipped to
/// [0, 1], sRGB curve (IEC 61966-2-1), 8 bits a channel.
pub fn screen_rgb(radiance: Rgb, exposure: f32) -> [u8; 3] {
    (radiance * exposure).to_array().map(screen_byte)
}

/// The byte that a screen shows as this linear value: clipped to [0, 1], sRGB
/// curve (IEC 61966-2-1), rounded.
fn screen_byte(linear: f32) -> u8 {
    let clipped = linear.clamp(0.0, 1.0);
    // Not a number becomes black.
    (srgb::encode(clipped) * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_follow_the_curve() {
        let expected = [(0.0, 0), (0.002, 7), (0.2, 124), (0.5, 188), (1.0, 255)];
        for (linear, byte) in expected {
            assert_eq!(screen_byte(linear), byte, "{linear}");
        }
        for (linear, byte) in [(-1.0, 0), (7.0, 255), (f32::INFINITY, 255), (f32::NAN, 0)] {
            assert_eq!(screen_byte(linear), byte, "{linear}");
        }
    }
}
