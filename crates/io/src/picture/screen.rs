//! Radiance as a screen shows it, 8 bits a channel.

use crate::srgb;
use traylib_math::{Grid, Rgb};

/// A picture of bytes: red, green and blue of each pixel, rows from the top.
pub(super) struct Screen {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) bytes: Vec<u8>,
}

impl Screen {
    /// An error if it has more columns or rows than can be counted.
    pub(super) fn new(
        radiance: &Grid<Rgb>,
        exposure: f32,
    ) -> Result<Self, std::num::TryFromIntError> {
        let pixels = radiance.values().iter();
        Ok(Self {
            width: radiance.width().try_into()?,
            height: radiance.height().try_into()?,
            bytes: pixels.flat_map(|&light| screen_rgb(light, exposure)).collect(),
        })
    }
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
