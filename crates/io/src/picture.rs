//! Pictures, to and from files.
//!
//! A picture is written completely or not at all ([`write_file`]).

mod exposure;
mod exr;
mod hdr;
mod pcx;
mod png;
mod screen;
mod tga;
mod tone;

pub use exposure::exposure_of;
pub(crate) use exposure::two_digits;
pub use exr::{ExrChannel, ExrFile, ExrLayer, load_exr, open_exr};
pub(crate) use exr::{ExrPicture, load_exr_within};
pub use png::png_texts;
pub use screen::{Look, screen_rgb};
pub use tone::Tone;

use crate::{Error, Warning, check_file, write_file};
use screen::Screen;
use std::path::Path;
use traylib_math::{Grid, Rgb};

type Cause = Box<dyn std::error::Error + Send + Sync>;

/// The description of a picture that its file has beside the pixels.
///
/// It goes into EXR and PNG files, by the names of [`attributes`](Self::attributes).
/// The other formats have no place for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PictureInfo {
    /// Factor on radiance in 8-bit pictures.
    pub exposure: f32,
    /// The curve that follows, there.
    pub tone: Tone,
    /// Program and version.
    pub program: String,
    /// The integrator that made it.
    pub integrator: String,
    /// The command that makes it again.
    pub command: String,
    /// The scene's name.
    pub scene: String,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Samples per pixel.
    pub spp: u64,
    /// Samples left out because they were not finite or negative.
    pub rejected_samples: u64,
    /// The frame of which it is a part; `None` if it is whole.
    pub frame: Option<PictureFrame>,
}

/// The frame of a picture that is a part of it. EXR files have it as their display window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureFrame {
    /// Columns and rows of the frame.
    pub size: (u32, u32),
    /// The frame's column and row in which the picture has its first.
    pub corner: (u32, u32),
}

impl PictureInfo {
    /// Names and texts for [`write_picture`]: `software`, `integrator`, `command`,
    /// `scene`, `seed`, `spp`, `exposure`, `rejectedSamples`, and `tone` unless it is linear: nothing that
    /// changes from run to run.
    pub fn attributes(&self) -> Vec<(String, String)> {
        let tone = (self.tone != Tone::Linear).then(|| ("tone", self.tone.to_string()));
        let texts = [
            ("software", self.program.clone()),
            ("integrator", self.integrator.clone()),
            ("command", self.command.clone()),
            ("scene", self.scene.clone()),
            ("seed", self.seed.to_string()),
            ("spp", self.spp.to_string()),
            ("exposure", self.exposure.to_string()),
            ("rejectedSamples", self.rejected_samples.to_string()),
        ];
        texts.into_iter().chain(tone).map(|(name, text)| (name.to_string(), text)).collect()
    }
}

/// Values of each pixel beside its light, for EXR files: the other formats have no place for them.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureLayer {
    /// Its name, which stands before those of its channels: `normal` in `normal.X`.
    pub name: &'static str,
    /// Names of its channels, as many as are kept.
    pub channels: &'static [&'static str],
    /// Values of up to three channels.
    pub values: Grid<Rgb>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Exr,
    Hdr,
    Tga,
    Pcx,
}

impl Format {
    fn of(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        match ending.to_ascii_lowercase().as_str() {
            "png" => Ok(Self::Png),
            "exr" => Ok(Self::Exr),
            "hdr" => Ok(Self::Hdr),
            "tga" => Ok(Self::Tga),
            "pcx" => Ok(Self::Pcx),
            _ => Err(Error::PictureFormat(path.to_path_buf())),
        }
    }

    /// The most columns and rows that are written.
    fn largest_size(self) -> (u32, u32) {
        match self {
            Self::Png | Self::Exr => (i32::MAX as u32, i32::MAX as u32),
            // Longer rows are not told from those of an older kind.
            Self::Hdr => (32_767, i32::MAX as u32),
            Self::Tga => (65_535, 65_535),
            // A row has an even number of bytes, which 16 bits count.
            Self::Pcx => (65_534, 65_535),
        }
    }
}

/// Writes radiance to a file; the ending of its name picks the format.
///
/// - `.png`: times the exposure, by the curve of tones, clipped to [0, 1], sRGB curve, 8 bits.
/// - `.tga`, `.pcx`: the same pixels; 24 bits, TGA not compressed.
/// - `.exr`: linear, 32-bit floats, channels R, G, B, lossless compression.
/// - `.hdr`: linear, rounded to 8 bits below the brightest band of each pixel;
///   nothing negative, nothing from 1.7·10³⁸ up.
///
/// The same radiance with the same words gives the same bytes.
///
/// # Errors
/// [`Error::PictureFormat`] for another ending, [`Error::Write`] if the file
/// cannot be written; what was there before then still is.
pub fn save_picture(path: &Path, radiance: &Grid<Rgb>, info: &PictureInfo) -> Result<(), Error> {
    save_picture_with(path, radiance, info, &[])
}

/// [`save_picture`] with layers beside the light, in EXR files.
///
/// # Errors
/// As `save_picture`.
pub fn save_picture_with(
    path: &Path,
    radiance: &Grid<Rgb>,
    info: &PictureInfo,
    layers: &[PictureLayer],
) -> Result<(), Error> {
    let extras = Extras { attributes: &info.attributes(), frame: info.frame, layers };
    write_with(path, radiance, Look { exposure: info.exposure, tone: info.tone }, extras)
}

/// The layers and attributes that an EXR file has beside the light; of it PNG files have the
/// attributes.
#[derive(Clone, Copy)]
struct Extras<'a> {
    attributes: &'a [(String, String)],
    frame: Option<PictureFrame>,
    layers: &'a [PictureLayer],
}

/// [`save_picture`] with any attributes, name and text. Characters beyond Latin-1
/// become question marks in EXR files. An exposure is a look, too.
///
/// # Errors
/// As `save_picture`.
pub fn write_picture(
    path: &Path,
    radiance: &Grid<Rgb>,
    look: impl Into<Look>,
    attributes: &[(String, String)],
) -> Result<(), Error> {
    write_with(path, radiance, look.into(), Extras { attributes, frame: None, layers: &[] })
}

fn write_with(
    path: &Path,
    radiance: &Grid<Rgb>,
    look: Look,
    extras: Extras<'_>,
) -> Result<(), Error> {
    let bytes = encode(Format::of(path)?, radiance, look, extras)
        .map_err(|cause| Error::Write { file: path.to_path_buf(), cause })?;
    write_file(path, &bytes)
}

fn encode(
    format: Format,
    radiance: &Grid<Rgb>,
    look: Look,
    extras: Extras<'_>,
) -> Result<Vec<u8>, Cause> {
    if radiance.values().is_empty() {
        return Err("it has no pixels".into());
    }
    let screen = || Screen::new(radiance, look);
    match format {
        Format::Png => png::encode(&screen()?, extras.attributes),
        Format::Tga => tga::encode(&screen()?),
        Format::Pcx => pcx::encode(&screen()?),
        Format::Exr => exr::encode(radiance, extras),
        Format::Hdr => hdr::encode(radiance),
    }
}

/// The bytes of an EXR file of this light, which says nothing else.
pub(crate) fn encode_exr(light: &Grid<Rgb>) -> Result<Vec<u8>, Cause> {
    exr::encode(light, Extras { attributes: &[], frame: None, layers: &[] })
}

/// Returns what of this light a file of this name cannot hold, as one warning about it: in 8-bit
/// pictures what is not a number, in `.hdr` also what is negative or has no bound. That 8-bit
/// pictures end at black and white is their nature.
///
/// # Errors
/// [`Error::PictureFormat`] for another ending.
pub fn losses(path: &Path, radiance: &Grid<Rgb>) -> Result<Option<Warning>, Error> {
    let (is_lost, what): (fn(f32) -> bool, _) = match Format::of(path)? {
        Format::Exr => return Ok(None),
        Format::Hdr => {
            (hdr::is_lost, "number that is negative, infinite or none, written as the nearest")
        }
        Format::Png | Format::Tga | Format::Pcx => {
            (f32::is_nan, "number that is none, written as black")
        }
    };
    let bands = radiance.values().iter().flat_map(|light| light.to_array());
    let count = bands.filter(|&band| is_lost(band)).count();
    let file = path.display().to_string();
    let warning =
        Warning { file, what: what.to_string(), count: u32::try_from(count).unwrap_or(u32::MAX) };
    Ok((count > 0).then_some(warning))
}

/// Tells whether [`save_picture`] will be able to write there, as far as can be known
/// before the picture exists: the format is known, and the folder takes new
/// files.
///
/// # Errors
/// [`Error::PictureFormat`] or [`Error::Write`], as `save_picture` would.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    Format::of(path)?;
    check_file(path)
}

/// [`check_writable`] for a picture of this size, for which a format may have no place.
///
/// # Errors
/// As `save_picture` would.
pub fn check_picture(path: &Path, width: u32, height: u32) -> Result<(), Error> {
    let (columns, rows) = Format::of(path)?.largest_size();
    if width > columns || height > rows {
        let cause = format!("its format has at most {columns} columns and {rows} rows").into();
        return Err(Error::Write { file: path.to_path_buf(), cause });
    }
    check_writable(path)
}

#[cfg(test)]
pub(crate) mod tests;
