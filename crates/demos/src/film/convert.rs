//! `film convert`.

use super::any::{is_film, load_texture_aloud};
use crate::VERSION;
use crate::checkpoint::picture_info;
use crate::outcome::Failure;
use crate::say::{say, say_line, tell_name};
use clap::Args;
use std::path::{Path, PathBuf};
use traylib_io::{
    PictureInfo, check_writable, load_film, losses, open_exr, save_picture, write_picture,
};

/// A picture to write anew.
#[derive(Args, Clone, Debug)]
pub struct ConvertOptions {
    /// Picture: EXR, HDR, PNG, JPEG, GIF (first frame), BMP, TGA or PCX; or a film
    #[arg(value_name = "IN")]
    pub input: PathBuf,

    /// Picture to write: .exr, .hdr, .png, .tga or .pcx
    #[arg(value_name = "OUT")]
    pub output: PathBuf,

    /// Factor on the light in .png, .tga and .pcx; .exr and .hdr keep the light
    /// itself [default: 1, of a film its own]
    #[arg(long, value_name = "X", value_parser = parse_exposure)]
    pub exposure: Option<f32>,
}

fn parse_exposure(text: &str) -> Result<f32, &'static str> {
    let number = text.parse().ok().filter(|x: &f32| x.is_finite() && *x > 0.0);
    number.ok_or("wanted a number above 0, as 0.5 or 2")
}

pub(super) fn convert(options: &ConvertOptions) -> Result<(), Failure> {
    let ConvertOptions { input, output, exposure } = options;
    check_writable(output)?;
    if is_film(input) {
        return convert_film(options);
    }
    let picture = load_texture_aloud(input)?;
    if picture.alpha.is_some() && !picture.alpha_is_undefined {
        say(format_args!("warning: {}: opacity left out, no format has it here", input.display()));
    }
    if let Some(warning) = losses(output, &picture.pixels)? {
        say_line("warning", warning);
    }
    write_picture(output, &picture.pixels, exposure.unwrap_or(1.0), &attributes(input))?;
    tell_name(output)
}

/// The picture of a film, with the same bytes as that of the program which rendered it.
fn convert_film(options: &ConvertOptions) -> Result<(), Failure> {
    let ConvertOptions { input, output, exposure } = options;
    let (film, about) = load_film(input)?;
    let info = picture_info(&about, film.passes());
    let exposure = exposure.unwrap_or(info.exposure);
    save_picture(output, &film.into_picture(), &PictureInfo { exposure, ..info })?;
    tell_name(output)
}

/// Returns the attributes by which an EXR file says how it was made; of any other picture, only the
/// program that converts it.
fn attributes(input: &Path) -> Vec<(String, String)> {
    let own = || vec![("software".to_string(), format!("film {VERSION}"))];
    let layers = open_exr(input).map(|file| file.layers.into_iter());
    layers.ok().and_then(|mut layers| layers.next()).map_or_else(own, |layer| layer.attributes)
}
