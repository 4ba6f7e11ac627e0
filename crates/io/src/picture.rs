//! Pictures, to and from files.
//!
//! A picture is written completely or not at all: to a file beside the target,
//! which then takes its name.

mod exr;
mod png;
mod replace;

pub use exr::{ExrChannel, ExrFile, ExrLayer, load_exr, open_exr};
pub use png::screen_rgb;

use crate::Error;
use std::path::Path;
use traylib_math::{Grid, Rgb};

/// What a picture says of itself in its file.
///
/// All of it goes into the header of an EXR file; of it a PNG needs the
/// exposure only.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureInfo {
    /// Factor on radiance in 8-bit pictures.
    pub exposure: f32,
    /// Program and version.
    pub program: String,
    /// The integrator that made it.
    pub integrator: String,
    /// The scene's name.
    pub scene: String,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Samples per pixel.
    pub spp: u64,
    /// Seconds the render took.
    pub seconds: f64,
    /// Samples left out because they were not finite or negative.
    pub rejected_samples: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Exr,
}

impl Format {
    fn of(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        match ending.to_ascii_lowercase().as_str() {
            "png" => Ok(Self::Png),
            "exr" => Ok(Self::Exr),
            _ => Err(Error::PictureFormat(path.to_path_buf())),
        }
    }
}

/// Writes radiance to a file; the ending of its name picks the format.
///
/// - `.png`: times the exposure, clipped to [0, 1], sRGB curve, 8 bits.
/// - `.exr`: linear, 32-bit floats, channels R, G, B, lossless compression.
///
/// The same radiance gives the same bytes of pixels. The attributes in the header
/// of an EXR file stand in any order.
///
/// # Errors
/// [`Error::PictureFormat`] for another ending, [`Error::Write`] if the file
/// cannot be written; what was there before then still is.
pub fn save_picture(path: &Path, radiance: &Grid<Rgb>, info: &PictureInfo) -> Result<(), Error> {
    let encoded = match Format::of(path)? {
        Format::Png => png::encode(radiance, info.exposure),
        Format::Exr => exr::encode(radiance, info),
    };
    let written = encoded.and_then(|bytes| Ok(replace::replace(path, &bytes)?));
    written.map_err(|cause| Error::Write { file: path.to_path_buf(), cause })
}

/// Whether [`save_picture`] will be able to write there, as far as can be known
/// before the picture exists: the format is known, and the folder takes new
/// files.
///
/// # Errors
/// [`Error::PictureFormat`] or [`Error::Write`], as `save_picture` would.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    Format::of(path)?;
    replace::check(path).map_err(|e| Error::Write { file: path.to_path_buf(), cause: e.into() })
}

#[cfg(test)]
mod tests;
