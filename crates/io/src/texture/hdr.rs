//! Radiance pictures (`.hdr`, `.pic`).
//!
//! Lines of text, then rows of pixels: three mantissas and an exponent they share.
//! A row is compressed band by band, or in the older way pixel by pixel, or not.
//! `EXPOSURE` and other lines that change the meaning of values are not looked at.
//!
//! Source: Radiance's `color.c` and "File formats" of its reference manual.

use super::{Decoded, TextureError, TextureLimits};
use traylib_math::{Grid, Rgb};

/// Mantissas and exponent.
type Rgbe = [u8; 4];

/// Widths that the newer compression can be used for.
const PACKED_WIDTHS: std::ops::Range<usize> = 8..32_768;

pub(super) fn decode(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let mut reader = Reader { bytes, at: 0 };
    reader.skip_header()?;
    let (width, height) = reader.size()?;
    limits.check(width, height)?;
    let (width, height) = (width as usize, height as usize);
    let mut row = vec![Rgbe::default(); width];
    let mut pixels = Vec::with_capacity(width * height);
    for _ in 0..height {
        reader.row(&mut row)?;
        pixels.extend(row.iter().copied().map(light));
    }
    let pixels = Grid::from_values(width, height, pixels).expect("as many as rows have");
    Ok(Decoded { pixels, alpha: None, repairs: Vec::new() })
}

/// In `f64`, since the least step is too small for a power of an `f32`.
fn light([r, g, b, exponent]: Rgbe) -> Rgb {
    if exponent == 0 {
        return Rgb::BLACK;
    }
    let step = 2.0_f64.powi(i32::from(exponent) - 136);
    let [r, g, b] = [r, g, b].map(|mantissa| (f64::from(mantissa) * step) as f32);
    Rgb::new(r, g, b)
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Reader<'a> {
    fn fail<T>(&self, what: &'static str) -> Result<T, TextureError> {
        Err(TextureError::Radiance { at: self.at, what })
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], TextureError> {
        let Some(found) = self.bytes[self.at..].first_chunk() else {
            return self.fail("it ends within the picture");
        };
        self.at += N;
        Ok(*found)
    }

    fn line(&mut self) -> Result<&'a [u8], TextureError> {
        let rest = &self.bytes[self.at..];
        let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
            return self.fail("it ends within the header");
        };
        self.at += length + 1;
        Ok(rest[..length].trim_ascii())
    }

    /// Up to the empty line.
    fn skip_header(&mut self) -> Result<(), TextureError> {
        loop {
            let at = self.at;
            let line = self.line()?;
            if line.is_empty() {
                return Ok(());
            }
            if line.strip_prefix(b"FORMAT=").is_some_and(|name| name != b"32-bit_rle_rgbe") {
                let what = "the format is not 32-bit_rle_rgbe, the only one that is read";
                return Err(TextureError::Radiance { at, what });
            }
        }
    }

    fn size(&mut self) -> Result<(u32, u32), TextureError> {
        let at = self.at;
        let line = std::str::from_utf8(self.line()?).unwrap_or_default();
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let size = match words[..] {
            ["-Y", height, "+X", width] => width.parse().ok().zip(height.parse().ok()),
            _ => None,
        };
        let what = "wanted is the size as `-Y 300 +X 400`: other orders are not read";
        size.ok_or(TextureError::Radiance { at, what })
    }

    fn row(&mut self, row: &mut [Rgbe]) -> Result<(), TextureError> {
        let first = self.take::<4>()?;
        let [2, 2, high @ 0..128, low] = first else { return self.plain_row(first, row) };
        let length = usize::from(u16::from_be_bytes([high, low]));
        if !PACKED_WIDTHS.contains(&row.len()) {
            return self.plain_row(first, row);
        }
        if length != row.len() {
            return self.fail("a row is not as long as the picture is wide");
        }
        (0..4).try_for_each(|band| self.band(row, band))
    }

    /// One byte of each pixel of a row: runs of equal ones and of others.
    fn band(&mut self, row: &mut [Rgbe], band: usize) -> Result<(), TextureError> {
        let mut x = 0;
        while x < row.len() {
            let [code] = self.take()?;
            let count = usize::from(if code > 128 { code - 128 } else { code });
            let Some(pixels) = row[x..].get_mut(..count) else { return self.beyond() };
            let same = if code > 128 { Some(self.take::<1>()?) } else { None };
            for pixel in pixels {
                [pixel[band]] = same.map_or_else(|| self.take(), Ok)?;
            }
            x += count;
        }
        Ok(())
    }

    /// Pixels as they are, among them repetitions: mantissas of one and a count. One
    /// right after another counts in units of 256 times its own.
    fn plain_row(&mut self, first: Rgbe, row: &mut [Rgbe]) -> Result<(), TextureError> {
        if matches!(first, [1, 1, 1, _]) {
            return self.fail("a row begins with a repetition");
        }
        row[0] = first;
        let (mut x, mut unit) = (1, 1_usize);
        while x < row.len() {
            let pixel = self.take()?;
            let (value, count);
            (value, count, unit) = match pixel {
                [1, 1, 1, n] => {
                    (row[x - 1], unit.saturating_mul(n.into()), unit.saturating_mul(256))
                }
                _ => (pixel, 1, 1),
            };
            let Some(pixels) = row[x..].get_mut(..count) else { return self.beyond() };
            pixels.fill(value);
            x += count;
        }
        Ok(())
    }

    fn beyond(&self) -> Result<(), TextureError> {
        self.fail("a run goes beyond its row")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(size: &str, body: &[u8]) -> Result<Vec<Rgb>, String> {
        let head = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}\n");
        let bytes = [head.as_bytes(), body].concat();
        let decoded = decode(&bytes, TextureLimits { pixels: 100, file_bytes: 100 });
        decoded.map(|found| found.pixels.values().to_vec()).map_err(|error| error.to_string())
    }

    #[test]
    fn values_are_mantissas_times_a_power_of_two() {
        let found = read("-Y 2 +X 1", &[128, 64, 0, 129, 255, 1, 0, 1]).unwrap();
        let least = 2.0_f32.powi(-100) * 2.0_f32.powi(-35);
        assert_eq!(found, [Rgb::new(1.0, 0.5, 0.0), Rgb::new(255.0 * least, least, 0.0)]);
        assert_eq!(read("-Y 1 +X 1", &[9, 9, 9, 0]).unwrap(), [Rgb::BLACK]);
    }

    #[test]
    fn old_repetitions_count_in_growing_units() {
        // One pixel, again none and then 256 times: too many. Or 2 times, and one more.
        let one = [128, 128, 128, 129];
        let too_many = [&one[..], &[1, 1, 1, 0], &[1, 1, 1, 1]].concat();
        assert!(read("-Y 1 +X 9", &too_many).unwrap_err().ends_with("beyond its row"));
        let three = [&one[..], &[1, 1, 1, 2], &[128, 128, 128, 130]].concat();
        let expected = [1.0, 1.0, 1.0, 2.0].map(|x| Rgb::new(x, x, x));
        assert_eq!(read("-Y 1 +X 4", &three).unwrap(), expected);
        // Any number of empty ones is no reason to panic.
        let empty = [&one[..], &[1, 1, 1, 0].repeat(20), &one].concat();
        assert_eq!(read("-Y 1 +X 2", &empty).unwrap(), [Rgb::WHITE; 2]);
    }

    #[test]
    fn bands_are_unpacked() {
        let runs = [0x88, 128, 0x88, 64, 4, 1, 2, 3, 4, 0x84, 0, 0x88, 129];
        let found = read("-Y 1 +X 8", &[&[2, 2, 0, 8][..], &runs].concat()).unwrap();
        let blue = [1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0].map(|x| x / 128.0);
        assert_eq!(found, blue.map(|b| Rgb::new(1.0, 0.5, b)));
    }

    #[test]
    fn places_are_named() {
        for (size, body, expected) in [
            ("+Y 1 +X 1", &[][..], "Radiance: at byte 35: wanted is the size"),
            ("-Y 1 +X 1", &[1, 2, 3], "Radiance: at byte 45: it ends within the picture"),
            ("-Y 1 +X 8", &[2, 2, 0, 9], "Radiance: at byte 49: a row is not as long"),
            ("-Y 1 +X 8", &[2, 2, 0, 8, 0x89, 0], "Radiance: at byte 50: a run goes beyond"),
            ("-Y 1 +X 2", &[1, 1, 1, 1], "Radiance: at byte 49: a row begins with"),
            ("-Y 11 +X 10", &[], "10x11 pixels are more than the 100 allowed"),
            ("-Y 0 +X 10", &[], "it has no pixels"),
        ] {
            let said = read(size, body).unwrap_err();
            assert!(said.starts_with(expected), "{size}: {said}");
        }
    }
}
