//! Pictures of any program, as light and opacity.
//!
//! The content of a file says what it is, whatever it is called, and with that
//! whether its numbers are light or follow a curve ([`Coding`]). TGA alone has no
//! first bytes of its own: it is known by a header that makes sense, by its last
//! bytes, or for want of both by the ending of its name.
//!
//! | format | what is read |
//! |---|---|
//! | PNG | all kinds, 16 bits a channel too; gamma and colour profiles are not looked at |
//! | JPEG | baseline and progressive; which way the camera was held is not looked at |
//! | GIF | the first frame, at its place on the screen and cut to it; transparent black around it |
//! | BMP | 1, 4, 8, 16, 24, 32 bits, with runs too; opacity that is nowhere is taken for everywhere |
//! | TGA | types 1, 2, 3 and 9, 10, 11; 8, 15, 16, 24, 32 bits; all four orders |
//! | PCX | 1, 2, 4, 8 bits in one plane, 1 bit in two to four, 24 bits |
//! | Radiance | RGBE, in all eight orders; `EXPOSURE` and `COLORCORR` taken back, other primaries converted |
//! | EXR | what [`load_exr`](crate::load_exr) reads, and the opacity of channel `A` |
//!
//! All but the last two have 8 or 16 bits a channel and do not say which curve
//! these follow; they are taken for sRGB. The attribute bit of 16-bit TGA pixels
//! is not opacity here, whatever the header says: many files have it zero in all
//! pixels.

mod gif;
mod hdr;
mod pcx;
mod raster;
mod sniff;

use crate::picture::{ExrPicture, load_exr_within};
use crate::texture_error::check_memory;
use crate::{Error, TextureError, Warning};
use sniff::Format;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use traylib_math::{Grid, Rgb};

/// Bounds on what a picture file may claim. Memory is taken only within.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextureLimits {
    /// Pixels. Each takes 16 bytes as light and opacity, and up to 8 on the way.
    pub pixels: u64,
    /// Bytes of the file.
    pub file_bytes: u64,
}

impl Default for TextureLimits {
    /// 2²³ pixels, as 4096 × 2048, and 2²⁵ bytes: together less than 256 MiB.
    fn default() -> Self {
        Self { pixels: 1 << 23, file_bytes: 1 << 25 }
    }
}

impl TextureLimits {
    /// Refuses a size before memory is taken for it.
    fn check(self, width: u32, height: u32) -> Result<(), TextureError> {
        match u64::from(width) * u64::from(height) {
            0 => Err(TextureError::Empty),
            pixels if pixels > self.pixels => {
                Err(TextureError::TooLarge { width, height, most: self.pixels })
            }
            pixels => check_memory(pixels.saturating_mul(BYTES_OF_A_PIXEL)),
        }
    }
}

/// The most bytes that a pixel takes: as a decoder has it, with four channels of 16 bits, and as
/// light and opacity.
pub(crate) const BYTES_OF_A_PIXEL: u64 = 8 + 8 + 16;

/// The coding by which the numbers of a file stand for light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    /// They are light itself: Radiance and EXR.
    Linear,
    /// They follow the curve of sRGB (IEC 61966-2-1): all other formats.
    Srgb,
}

/// A picture to look up.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Linear light; row 0 is at the top. In formats of 8 or 16 bits a channel
    /// from 0 to 1, else as stored.
    pub pixels: Grid<Rgb>,
    /// Opacity from 0 to 1, in EXR as stored; of the same size. `None` if every pixel is
    /// opaque.
    pub alpha: Option<Grid<f32>>,
    /// True if the file says that its opacity is undefined and only to be kept, as TGA can: who
    /// shows the picture takes it for opaque.
    pub alpha_is_undefined: bool,
    /// The coding by which the numbers in the file stand for light.
    pub coding: Coding,
    /// The warnings: what was repaired.
    pub warnings: Vec<Warning>,
}

/// Reads a picture file of any format. An EXR file may have four values a pixel, in
/// all its channels and layers.
///
/// # Errors
/// [`Error::ReadPicture`] with a [`TextureError`] inside; of an EXR file what
/// [`load_exr`](crate::load_exr) says.
pub fn load_texture(path: &Path, limits: TextureLimits) -> Result<Texture, Error> {
    let bytes = read(path, limits).map_err(|cause| in_file(path, cause))?;
    if bytes.starts_with(sniff::EXR) {
        let ExrPicture { pixels, alpha } = load_exr_within(path, limits.pixels)?;
        let is_opaque = |alpha: &Grid<f32>| alpha.values().iter().all(|&value| value >= 1.0);
        return Ok(Texture {
            pixels,
            alpha: alpha.filter(|alpha| !is_opaque(alpha)),
            alpha_is_undefined: false,
            coding: Coding::Linear,
            warnings: Vec::new(),
        });
    }
    texture_from_bytes(&bytes, path, limits)
}

/// Reads a picture of any format but EXR. The name is for messages, and to know a
/// TGA file by its ending.
///
/// # Errors
/// [`Error::ReadPicture`] with a [`TextureError`] inside.
pub fn texture_from_bytes(
    bytes: &[u8],
    name: &Path,
    limits: TextureLimits,
) -> Result<Texture, Error> {
    let Decoded { pixels, alpha, alpha_is_undefined, coding, repairs } =
        decode(bytes, name, limits).map_err(|cause| in_file(name, cause))?;
    let file = name.display().to_string();
    let warning = |what: &str| Warning { file: file.clone(), what: what.to_string(), count: 1 };
    Ok(Texture {
        pixels,
        alpha,
        alpha_is_undefined,
        coding,
        warnings: repairs.into_iter().map(warning).collect(),
    })
}

fn in_file(path: &Path, cause: TextureError) -> Error {
    Error::ReadPicture { file: path.to_path_buf(), cause: cause.into() }
}

fn read(path: &Path, limits: TextureLimits) -> Result<Vec<u8>, TextureError> {
    let mut bytes = Vec::new();
    File::open(path)?.take(limits.file_bytes.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limits.file_bytes {
        return Err(TextureError::TooLong(limits.file_bytes));
    }
    Ok(bytes)
}

/// The output of a decoder.
struct Decoded {
    pixels: Grid<Rgb>,
    alpha: Option<Grid<f32>>,
    alpha_is_undefined: bool,
    coding: Coding,
    /// The repairs, in words, each kind once.
    repairs: Vec<&'static str>,
}

fn decode(bytes: &[u8], name: &Path, limits: TextureLimits) -> Result<Decoded, TextureError> {
    match Format::of(bytes, name).ok_or(TextureError::UnknownFormat)? {
        Format::Png => raster::png(bytes, limits),
        Format::Jpeg => raster::jpeg(bytes, limits),
        Format::Gif => raster::gif(bytes, limits),
        Format::Bmp => raster::bmp(bytes, limits),
        Format::Tga => raster::tga(bytes, limits),
        Format::Pcx => pcx::decode(bytes, limits),
        Format::Hdr => hdr::decode(bytes, limits),
    }
}

#[cfg(test)]
mod tests;
