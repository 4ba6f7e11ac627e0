//! Lines of text and scan lines of pixels, from bytes.

use super::Rgbe;
use crate::texture::TextureError;

/// Lengths that the newer compression can be used for.
const PACKED_LENGTHS: std::ops::Range<usize> = 8..32_768;

pub(super) struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    /// Bytes read so far.
    pub(super) fn at(&self) -> usize {
        self.at
    }

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

    /// A line of the header, without blanks at its end.
    pub(super) fn line(&mut self) -> Result<&'a [u8], TextureError> {
        let rest = &self.bytes[self.at..];
        let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
            return self.fail("it ends within the header");
        };
        self.at += length + 1;
        Ok(rest[..length].trim_ascii_end())
    }

    pub(super) fn scan_line(&mut self, pixels: &mut [Rgbe]) -> Result<(), TextureError> {
        let first = self.take::<4>()?;
        let [2, 2, high @ 0..128, low] = first else { return self.plain(first, pixels) };
        let length = usize::from(u16::from_be_bytes([high, low]));
        if !PACKED_LENGTHS.contains(&pixels.len()) {
            return self.plain(first, pixels);
        }
        if length != pixels.len() {
            return self.fail("a scan line is not as long as the size says");
        }
        (0..4).try_for_each(|band| self.band(pixels, band))
    }

    /// One byte of each pixel: runs of equal ones and of others.
    fn band(&mut self, pixels: &mut [Rgbe], band: usize) -> Result<(), TextureError> {
        let mut x = 0;
        while x < pixels.len() {
            let [code] = self.take()?;
            let count = usize::from(if code > 128 { code - 128 } else { code });
            let Some(run) = pixels[x..].get_mut(..count) else { return self.beyond() };
            let same = if code > 128 { Some(self.take::<1>()?) } else { None };
            for pixel in run {
                [pixel[band]] = same.map_or_else(|| self.take(), Ok)?;
            }
            x += count;
        }
        Ok(())
    }

    /// Pixels as they are, among them repetitions: mantissas of one and a count. One
    /// right after another counts in units of 256 times its own.
    fn plain(&mut self, first: Rgbe, pixels: &mut [Rgbe]) -> Result<(), TextureError> {
        if matches!(first, [1, 1, 1, _]) {
            return self.fail("a scan line begins with a repetition");
        }
        pixels[0] = first;
        let (mut x, mut unit) = (1, 1_usize);
        while x < pixels.len() {
            let pixel = self.take()?;
            let (value, count);
            (value, count, unit) = match pixel {
                [1, 1, 1, n] => {
                    (pixels[x - 1], unit.saturating_mul(n.into()), unit.saturating_mul(256))
                }
                _ => (pixel, 1, 1),
            };
            let Some(run) = pixels[x..].get_mut(..count) else { return self.beyond() };
            run.fill(value);
            x += count;
        }
        Ok(())
    }

    fn beyond(&self) -> Result<(), TextureError> {
        self.fail("a run goes beyond its scan line")
    }
}
