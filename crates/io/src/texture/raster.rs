//! Formats of 8 or 16 bits a channel: to linear light.

use super::gif::with_screen;
use super::{Coding, Decoded, TextureError, TextureLimits};
use crate::Fault;
use crate::srgb;
use image::codecs::bmp::BmpDecoder;
use image::codecs::gif::GifDecoder;
use image::codecs::jpeg::JpegDecoder;
use image::codecs::png::PngDecoder;
use image::codecs::tga::TgaDecoder;
use image::{ColorType, DynamicImage, ImageDecoder, ImageError, Limits};
use std::io::Cursor;
use traylib_math::{Grid, Rgb};

pub(super) fn png(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), memory(limits));
    picture("PNG", decoder, limits).map(linear)
}

pub(super) fn gif(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let bytes = with_screen(bytes);
    picture("GIF", GifDecoder::new(Cursor::new(&bytes)), limits).map(linear)
}

/// Decodes a BMP file. Opacity that is zero in all pixels is left out: many programs leave its
/// place in the header so.
pub(super) fn bmp(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let mut decoded = picture("BMP", BmpDecoder::new(Cursor::new(bytes)), limits).map(linear)?;
    let is_nowhere = |alpha: &Grid<f32>| alpha.values().iter().all(|&value| value == 0.0);
    decoded.alpha = decoded.alpha.filter(|alpha| !is_nowhere(alpha));
    Ok(decoded)
}

/// The decoder fills what is missing at the end.
pub(super) fn jpeg(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    let mut decoded = picture("JPEG", JpegDecoder::new(Cursor::new(bytes)), limits).map(linear)?;
    // No such pair is within the data of a scan.
    let last = |marker: [u8; 2]| bytes.windows(2).rposition(|pair| pair == marker);
    if last([0xff, 0xd9]) < last([0xff, 0xda]) {
        decoded.repairs.push("cut off, the end of the picture is missing");
    }
    Ok(decoded)
}

/// The decoder takes unknown types for grey, and the fourth byte of pixels for
/// opacity where the header says that there is none.
pub(super) fn tga(bytes: &[u8], limits: TextureLimits) -> Result<Decoded, TextureError> {
    const TYPES: [u8; 6] = [1, 2, 3, 9, 10, 11];
    if bytes.get(2).is_some_and(|kind| !TYPES.contains(kind)) {
        let source = "the image type is none of 1, 2, 3, 9, 10 and 11".into();
        return Err(TextureError::Decoder { format: "TGA", fault: Fault::Unsupported, source });
    }
    let mut decoded = picture("TGA", TgaDecoder::new(Cursor::new(bytes)), limits).map(linear)?;
    let alpha_bits = bytes.get(17).map_or(0, |descriptor| descriptor & 0x0f);
    let attributes = tga_attributes(bytes);
    let is_there = alpha_bits > 0 && !matches!(attributes, Some(0 | 1));
    decoded.alpha = decoded.alpha.filter(|_| is_there);
    decoded.alpha_is_undefined = attributes == Some(2);
    Ok(decoded)
}

/// Returns the meaning of the fourth byte by the extension area of version 2: 0 that there is none,
/// 1 that it means nothing, 2 that it is undefined but to be kept, more that it is opacity.
fn tga_attributes(bytes: &[u8]) -> Option<u8> {
    const KIND: usize = 494;
    let footer = bytes.last_chunk::<26>()?;
    let (offsets, signature) = footer.split_at(8);
    let at = u32::from_le_bytes(*offsets.first_chunk()?) as usize;
    let has_area = signature.starts_with(b"TRUEVISION-XFILE") && at > 0;
    bytes.get(at..)?.get(KIND).copied().filter(|_| has_area)
}

/// Beside the picture, of 8 bytes a pixel at most, a decoder needs rows and tables.
fn memory(limits: TextureLimits) -> Limits {
    let mut memory = Limits::no_limits();
    memory.max_alloc = Some(limits.pixels.saturating_mul(8).saturating_add(4 << 20));
    memory
}

fn picture<D: ImageDecoder>(
    format: &'static str,
    decoder: Result<D, ImageError>,
    limits: TextureLimits,
) -> Result<DynamicImage, TextureError> {
    let failed = |error: ImageError| TextureError::Decoder {
        format,
        fault: match &error {
            ImageError::Unsupported(_) => Fault::Unsupported,
            ImageError::Decoding(_)
            | ImageError::Encoding(_)
            | ImageError::Parameter(_)
            | ImageError::Limits(_)
            | ImageError::IoError(_) => Fault::of(&error),
        },
        source: error.into(),
    };
    let mut decoder = decoder.map_err(failed)?;
    let (width, height) = decoder.dimensions();
    limits.check(width, height)?;
    decoder.set_limits(memory(limits)).map_err(failed)?;
    DynamicImage::from_decoder(decoder).map_err(failed)
}

fn linear(picture: DynamicImage) -> Decoded {
    use ColorType::{L16, La16, Rgb16, Rgba16};
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    if matches!(picture.color(), L16 | La16 | Rgb16 | Rgba16) {
        let pixels = picture.into_rgba16().into_raw();
        let part = |value: u16| f32::from(value) / f32::from(u16::MAX);
        return decoded(
            width,
            height,
            pixels.as_chunks().0,
            |value| srgb::decode(part(value)),
            part,
        );
    }
    from_rgba8(width, height, picture.into_rgba8().into_raw().as_chunks().0)
}

/// Light and opacity of bytes, red first.
pub(super) fn from_rgba8(width: usize, height: usize, pixels: &[[u8; 4]]) -> Decoded {
    let part = |value: u8| f32::from(value) / f32::from(u8::MAX);
    let curve: [f32; 256] = std::array::from_fn(|value| srgb::decode(part(value as u8)));
    decoded(width, height, pixels, |value| curve[usize::from(value)], part)
}

fn decoded<T: Copy>(
    width: usize,
    height: usize,
    pixels: &[[T; 4]],
    light: impl Fn(T) -> f32,
    opacity: impl Fn(T) -> f32,
) -> Decoded {
    let colour = |&[r, g, b, _]: &[T; 4]| Rgb::new(light(r), light(g), light(b));
    let alpha: Vec<f32> = pixels.iter().map(|pixel| opacity(pixel[3])).collect();
    let is_opaque = alpha.iter().all(|&value| value == 1.0);
    let colours = pixels.iter().map(colour).collect();
    Decoded {
        pixels: Grid::from_values(width, height, colours).expect("one a pixel"),
        alpha: Grid::from_values(width, height, alpha).filter(|_| !is_opaque),
        alpha_is_undefined: false,
        coding: Coding::Srgb,
        repairs: Vec::new(),
    }
}
