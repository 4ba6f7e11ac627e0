//! A picture of any format that can be read.

use crate::outcome::Failure;
use crate::say::say_line;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use traylib_io::{
    ExrChannel, ExrFile, ExrLayer, MAX_PIXELS, Texture, TextureLimits, load_exr, load_film,
    load_texture, open_exr, png_texts,
};
use traylib_math::{Grid, Rgb};

/// Larger than for a texture that a scene brings along: this picture somebody wants
/// as it is.
const LIMITS: TextureLimits = TextureLimits { pixels: MAX_PIXELS, file_bytes: 1 << 32 };

/// The light of a picture.
pub(super) fn load(path: &Path) -> Result<Grid<Rgb>, Failure> {
    if is_film(path) {
        Ok(load_film(path)?.0.into_picture())
    } else if is_exr(path) {
        Ok(load_exr(path)?)
    } else {
        Ok(load_texture_aloud(path)?.pixels)
    }
}

/// The light of a picture with its opacity; tells what was repaired.
pub(super) fn load_texture_aloud(path: &Path) -> Result<Texture, Failure> {
    let picture = load_texture(path, LIMITS)?;
    for warning in &picture.warnings {
        say_line("warning", warning);
    }
    Ok(picture)
}

/// Reads all that is in a picture's file. One that is not EXR has a layer of red, green and blue
/// light, and opacity if some is; what it says of itself is known of PNG alone.
pub(super) fn open(path: &Path) -> Result<ExrFile, Failure> {
    if is_exr(path) {
        return Ok(open_exr(path)?);
    }
    let Texture { pixels, alpha, .. } = load_texture_aloud(path)?;
    let (width, height) = (pixels.width(), pixels.height());
    let channel = |name: &str, values: Vec<f32>| ExrChannel {
        name: name.to_owned(),
        kind: "light",
        complete: true,
        values,
    };
    let band = |n: usize| pixels.values().iter().map(|light| light.to_array()[n]).collect();
    let mut channels = vec![channel("B", band(2)), channel("G", band(1)), channel("R", band(0))];
    channels.extend(alpha.map(|alpha| channel("A", alpha.values().to_vec())));
    channels.sort_by(|a, b| a.name.cmp(&b.name));
    let mut attributes = png_texts(path);
    attributes.sort();
    let layer = ExrLayer { name: None, at: [0, 0], width, height, channels, attributes };
    Ok(ExrFile { width, height, chromaticities: None, layers: vec![layer] })
}

/// Judges by content; what is damaged may be one all the same.
pub(super) fn is_film(path: &Path) -> bool {
    starts_with(path, b"\x89FILM").unwrap_or_else(|| ends_with(path, "film"))
}

/// Judges by content, or by the name where there is none to see.
fn is_exr(path: &Path) -> bool {
    starts_with(path, &[0x76, 0x2f, 0x31, 0x01]).unwrap_or_else(|| ends_with(path, "exr"))
}

/// `None` where there is nothing to see.
fn starts_with(path: &Path, bytes: &[u8]) -> Option<bool> {
    let mut begin = Vec::new();
    let read = File::open(path).and_then(|file| file.take(8).read_to_end(&mut begin));
    (read.is_ok() && !begin.is_empty()).then(|| begin.starts_with(bytes))
}

fn ends_with(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}
