//! The header of a Radiance file: what it says of the values of its pixels.

use super::reader::Reader;
use crate::chromaticities::{Chromaticities, Conversion};
use crate::texture::TextureError;
use traylib_math::Rgb;
use traylib_math::glam::{DMat3, DVec3};

/// From stored values to light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Header {
    /// The divisors of stored values: each line multiplied them further.
    multiplied: DVec3,
    /// From the primaries of the file to ours.
    conversion: Conversion,
}

impl Header {
    /// Up to the empty line. Lines that begin with a blank were copied from other
    /// pictures and say nothing of this one.
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Self, TextureError> {
        let mut header = Self { multiplied: DVec3::ONE, conversion: Conversion::None };
        loop {
            let at = reader.at();
            let line = reader.line()?;
            if line.is_empty() {
                return Ok(header);
            }
            header.note(line).map_err(|what| TextureError::Radiance { at, what })?;
        }
    }

    fn note(&mut self, line: &[u8]) -> Result<(), &'static str> {
        let Some((key, value)) = split(line) else { return Ok(()) };
        match key {
            b"FORMAT" if value.trim_ascii() != b"32-bit_rle_rgbe" => {
                return Err("the format is not 32-bit_rle_rgbe, the only one that is read");
            }
            b"EXPOSURE" => {
                let factor = numbers(value).map(|[factor]| DVec3::splat(factor));
                let what = "EXPOSURE is no number above 0";
                self.multiplied *= factor.filter(is_factor).ok_or(what)?;
            }
            b"COLORCORR" => {
                let factors = numbers(value).map(DVec3::from_array);
                let what = "COLORCORR is not three numbers above 0";
                self.multiplied *= factors.filter(is_factor).ok_or(what)?;
            }
            b"PRIMARIES" => {
                let what = "PRIMARIES are not x and y of red, green, blue and white";
                let primaries = numbers(value).map(Chromaticities::from_list).ok_or(what)?;
                self.conversion = primaries.conversion().ok_or(what)?;
            }
            _ => {}
        }
        Ok(())
    }

    /// The light that a stored value stands for.
    pub(super) fn light(&self, stored: DVec3) -> Rgb {
        let stored = stored / self.multiplied;
        let light = match self.conversion {
            Conversion::None => stored,
            Conversion::Matrix(matrix) => DMat3::mul_vec3(&matrix, stored),
        };
        Rgb::from(light.as_vec3().to_array())
    }
}

fn split(line: &[u8]) -> Option<(&[u8], &[u8])> {
    let equals = line.iter().position(|&byte| byte == b'=')?;
    Some((&line[..equals], &line[equals + 1..]))
}

/// The first N numbers; what stands behind them is not looked at, as Radiance does it.
fn numbers<const N: usize>(text: &[u8]) -> Option<[f64; N]> {
    let text = str::from_utf8(text).ok()?;
    let mut words = text.split_ascii_whitespace();
    let mut numbers = [0.0; N];
    for number in &mut numbers {
        *number = words.next()?.parse().ok()?;
    }
    Some(numbers)
}

fn is_factor(factors: &DVec3) -> bool {
    factors.is_finite() && factors.min_element() > 0.0
}
