//! `film convert`.

use super::any::{is_film, load_texture_aloud};
use crate::VERSION;
use crate::black::is_stepped;
use crate::checkpoint::picture_info;
use crate::exposure::Exposure;
use crate::outcome::Failure;
use crate::say::{say, say_line, tell_name};
use clap::Args;
use std::path::PathBuf;
use traylib_io::{
    Look, PictureInfo, Tone, check_writable, load_film, losses, open_exr, save_picture,
    write_picture,
};
use traylib_math::{Grid, Rgb};

/// A picture to write anew.
#[derive(Args, Clone, Debug)]
pub struct ConvertOptions {
    /// Picture: EXR, HDR, PNG, JPEG, GIF (first frame), BMP, TGA or PCX; or a film
    #[arg(value_name = "IN")]
    pub input: PathBuf,

    /// Picture to write: .exr, .hdr, .png, .tga or .pcx
    #[arg(value_name = "OUT")]
    pub output: PathBuf,

    /// Factor on the light in .png, .tga and .pcx; `auto` shows the middle of the picture
    /// as middle grey, and says by which factor; .exr and .hdr keep the light itself
    /// [default: 1, of a film its own]
    #[arg(long, value_name = "X")]
    pub exposure: Option<Exposure>,

    /// The curve that light follows in .png, .tga and .pcx: `linear`, or `filmic`, which
    /// keeps more of what is brighter than white [default: linear, of a film its own]
    #[arg(long, value_name = "CURVE")]
    pub tone: Option<Tone>,
}

impl ConvertOptions {
    /// Returns what a screen makes of a picture whose own look is another; tells which exposure
    /// was taken, if that was left to the picture.
    fn look(&self, picture: &Grid<Rgb>, own: Look) -> Look {
        let exposure = self.exposure.map_or(own.exposure, |exposure| {
            let taken = exposure.of(picture, own.exposure);
            exposure.tell(taken);
            taken
        });
        Look { exposure, tone: self.tone.unwrap_or(own.tone) }
    }
}

/// Attributes that tell of the look.
const EXPOSURE: &str = "exposure";
const TONE: &str = "tone";

pub(super) fn convert(options: &ConvertOptions) -> Result<(), Failure> {
    let ConvertOptions { input, output, .. } = options;
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
    let look = options.look(&picture.pixels, Look::from(1.0));
    write_picture(output, &picture.pixels, look, &attributes(options, look))?;
    tell_name(output)
}

/// The picture of a film, with the same bytes as that of the program which rendered it.
fn convert_film(options: &ConvertOptions) -> Result<(), Failure> {
    let ConvertOptions { input, output, .. } = options;
    let (film, about) = load_film(input)?;
    let info = picture_info(&about, film.passes());
    let picture = film.into_picture();
    let own = Look { exposure: info.exposure, tone: info.tone };
    let Look { exposure, tone } = options.look(&picture, own);
    save_picture(output, &picture, &PictureInfo { exposure, tone, ..info })?;
    tell_name(output)
}

/// Returns the attributes by which an EXR file says how it was made; of any other picture, only the
/// program that converts it.
///
/// What they say of the look is that of this picture, if it has 256 steps.
fn attributes(options: &ConvertOptions, look: Look) -> Vec<(String, String)> {
    let own = || vec![("software".to_string(), format!("film {VERSION}"))];
    let layers = open_exr(&options.input).map(|file| file.layers.into_iter());
    let first = layers.ok().and_then(|mut layers| layers.next());
    let mut attributes = first.map_or_else(own, |layer| layer.attributes);
    if is_stepped(&options.output) {
        attributes.retain(|(name, _)| name != TONE);
        let noted = attributes.iter_mut().find(|(name, _)| name == EXPOSURE);
        if let Some((_, exposure)) = noted {
            *exposure = look.exposure.to_string();
        } else if options.exposure.is_some() {
            attributes.push((EXPOSURE.to_string(), look.exposure.to_string()));
        }
        if look.tone != Tone::Linear {
            attributes.push((TONE.to_string(), look.tone.to_string()));
        }
    }
    attributes
}
