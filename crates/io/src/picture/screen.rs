//! Radiance as a screen shows it, 8 bits a channel.

use super::tone::Tone;
use crate::srgb;
use std::sync::LazyLock;
use traylib_math::{Grid, Rgb};

/// What a screen makes of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Factor on radiance.
    pub exposure: f32,
    /// The curve that follows.
    pub tone: Tone,
}

impl Look {
    /// Red, green and blue as a screen shows radiance: times the exposure, by the curve of tones,
    /// clipped to [0, 1], sRGB curve (IEC 61966-2-1), 8 bits a channel.
    pub fn bytes(self, radiance: Rgb) -> [u8; 3] {
        let light = (radiance * self.exposure).to_array();
        light.map(|band| screen_byte(self.tone.apply(band)))
    }
}

/// An exposure alone leaves light as it is.
impl From<f32> for Look {
    fn from(exposure: f32) -> Self {
        Self { exposure, tone: Tone::Linear }
    }
}

/// A picture of bytes: red, green and blue of each pixel, rows from the top.
pub(super) struct Screen {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) bytes: Vec<u8>,
}

impl Screen {
    /// An error if it has more columns or rows than can be counted.
    pub(super) fn new(radiance: &Grid<Rgb>, look: Look) -> Result<Self, std::num::TryFromIntError> {
        let pixels = radiance.values().iter();
        Ok(Self {
            width: radiance.width().try_into()?,
            height: radiance.height().try_into()?,
            bytes: pixels.flat_map(|&light| look.bytes(light)).collect(),
        })
    }
}

/// [`Look::bytes`] of an exposure alone.
pub fn screen_rgb(radiance: Rgb, exposure: f32) -> [u8; 3] {
    Look::from(exposure).bytes(radiance)
}

/// The byte that a screen shows as this linear value: clipped to [0, 1], sRGB
/// curve (IEC 61966-2-1), rounded. Not a number becomes black.
fn screen_byte(linear: f32) -> u8 {
    CURVE.byte(linear)
}

/// The values at which the bytes of the curve begin: to look them up takes a tenth of the time of a
/// power.
static CURVE: LazyLock<Curve> = LazyLock::new(Curve::new);

struct Curve {
    /// The least value that has this byte or a higher one.
    first: [f32; 256],
    /// The byte of the least value in each cell.
    cells: Vec<u8>,
}

/// A cell holds all numbers that have these bits but the lower ones: 128 cells from each
/// power of two to the next. So narrow that no cell reaches over more than two bytes.
const CELL_BITS: u32 = 16;

/// The first cell: all that is less than 2⁻¹³ is black.
const FIRST_CELL: u32 = (127 - 13) << 7;

impl Curve {
    fn new() -> Self {
        let first = std::array::from_fn(|byte| first_of(byte as u8));
        let cell = |number: u32| coded_byte(f32::from_bits(number << CELL_BITS));
        // The last one is that of 1 alone.
        let last_cell = 1.0_f32.to_bits() >> CELL_BITS;
        Self { first, cells: (FIRST_CELL..=last_cell).map(cell).collect() }
    }

    fn byte(&self, linear: f32) -> u8 {
        // What is not a number is not greater either.
        let clipped = if linear > 0.0 { linear.min(1.0) } else { 0.0 };
        let cell = (clipped.to_bits() >> CELL_BITS).saturating_sub(FIRST_CELL);
        let byte = self.cells[cell as usize];
        let next = byte.saturating_add(1);
        if clipped >= self.first[next as usize] { next } else { byte }
    }
}

/// The byte of a value in [0, 1], by its definition.
fn coded_byte(linear: f32) -> u8 {
    (srgb::encode(linear) * 255.0).round() as u8
}

/// The least value with this byte or a higher one: by bisection of the numbers in [0, 1],
/// whose bits are in their order.
fn first_of(byte: u8) -> f32 {
    let (mut low, mut high) = (0, 1.0_f32.to_bits());
    while low < high {
        let middle = u32::midpoint(low, high);
        if coded_byte(f32::from_bits(middle)) >= byte {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    f32::from_bits(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At each end of a byte or of a cell, and in between.
    #[test]
    fn bytes_that_are_looked_up_are_those_of_the_definition() {
        let ends = (0..=255).map(|byte| first_of(byte).to_bits());
        let cells = (FIRST_CELL - 3..=127 << 7).map(|cell| cell << CELL_BITS);
        let near = |bits: u32| (bits.saturating_sub(40)..=bits + 40).chain([bits + 20_000]);
        for bits in ends.chain(cells).flat_map(near) {
            let linear = f32::from_bits(bits).min(1.0);
            assert_eq!(screen_byte(linear), coded_byte(linear), "{linear}");
        }
    }

    #[test]
    fn tones_come_after_the_exposure_and_before_the_curve() {
        let look = Look { exposure: 0.5, tone: Tone::Filmic };
        // 2.54/3.16 of light is byte 232; nothing and too much have an end.
        assert_eq!(look.bytes(Rgb::new(2.0, -3.0, 1e30)), [232, 0, 255]);
        assert_eq!(look.bytes(Rgb::new(f32::NAN, f32::INFINITY, 0.0)), [0, 255, 0]);
        let linear = Look { tone: Tone::Linear, ..look };
        let light = Rgb::new(0.3, 1.7, 0.01);
        assert_eq!(linear.bytes(light), screen_rgb(light, 0.5));
    }

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
