//! `film convert`.

use super::any::load_texture_aloud;
use crate::VERSION;
use crate::outcome::Failure;
use crate::say::{say, say_line, tell_name};
use clap::Args;
use std::path::{Path, PathBuf};
use traylib_io::{check_writable, losses, open_exr, write_picture};

/// A picture to write anew.
#[derive(Args, Clone, Debug)]
pub struct ConvertOptions {
    /// Picture: EXR, HDR, PNG, JPEG, GIF (first frame), BMP, TGA or PCX
    #[arg(value_name = "IN")]
    pub input: PathBuf,

    /// Picture to write: .exr, .hdr, .png, .tga or .pcx
    #[arg(value_name = "OUT")]
    pub output: PathBuf,

    /// Factor on the light in .png, .tga and .pcx; .exr and .hdr keep the light
    /// itself
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = parse_exposure)]
    pub exposure: f32,
}

fn parse_exposure(text: &str) -> Result<f32, &'static str> {
    let number = text.parse().ok().filter(|x: &f32| x.is_finite() && *x > 0.0);
    number.ok_or("wanted a number above 0, as 0.5 or 2")
}

pub(super) fn convert(options: &ConvertOptions) -> Result<(), Failure> {
    let ConvertOptions { input, output, exposure } = options;
    check_writable(output)?;
    let picture = load_texture_aloud(input)?;
    if picture.alpha.is_some() && !picture.alpha_is_undefined {
        say(format_args!("warning: {}: opacity left out, no format has it here", input.display()));
    }
    if let Some(warning) = losses(output, &picture.pixels)? {
        say_line("warning", warning);
    }
    write_picture(output, &picture.pixels, *exposure, &attributes(input))?;
    tell_name(output)
}

/// How an EXR file says it was made; of any other picture only who converts it.
fn attributes(input: &Path) -> Vec<(String, String)> {
    let own = || vec![("software".to_string(), format!("film {VERSION}"))];
    let layers = open_exr(input).map(|file| file.layers.into_iter());
    layers.ok().and_then(|mut layers| layers.next()).map_or_else(own, |layer| layer.attributes)
}
