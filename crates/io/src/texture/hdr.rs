//! Radiance pictures (`.hdr`, `.pic`).
//!
//! Lines of text, then scan lines of pixels: three mantissas and an exponent they
//! share. A scan line is compressed band by band, or in the older way pixel by pixel,
//! or not. They may run along rows or columns, from any corner.
//!
//! Light is what was there before `EXPOSURE` and `COLORCORR` multiplied it, in the
//! bands that `PRIMARIES` names.
//!
//! Source: Radiance's `color.c`, `resolu.c` and "File formats" of its reference manual.

mod header;
mod order;
mod reader;

use super::{Coding, Decoded, TextureError, TextureLimits};
use header::Header;
use order::Order;
use reader::Reader;
use traylib_math::glam::DVec3;
use traylib_math::{Grid, Rgb};

/// Mantissas and exponent.
type Rgbe = [u8; 4];

pub(super) fn decode(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let mut reader = Reader::new(bytes);
    let header = Header::read(&mut reader)?;
    let order = Order::read(&mut reader)?;
    let [width, height] = order.size();
    limits.check(width, height)?;
    let (width, height) = (width as usize, height as usize);
    let mut pixels = Grid::filled(width, height, Rgb::BLACK);
    let mut scan_line = vec![Rgbe::default(); order.length()];
    for number in 0..order.count() {
        reader.scan_line(&mut scan_line)?;
        for (along, &stored) in scan_line.iter().enumerate() {
            let [x, y] = order.place(number, along);
            pixels.values_mut()[y * width + x] = header.light(value(stored));
        }
    }
    Ok(Decoded {
        pixels,
        alpha: None,
        alpha_is_undefined: false,
        coding: Coding::Linear,
        repairs: Vec::new(),
    })
}

/// In `f64`, since the least step is too small for a power of an `f32`.
fn value([r, g, b, exponent]: Rgbe) -> DVec3 {
    if exponent == 0 {
        return DVec3::ZERO;
    }
    let step = 2.0_f64.powi(i32::from(exponent) - 136);
    DVec3::new(r.into(), g.into(), b.into()) * step
}

#[cfg(test)]
mod tests;
