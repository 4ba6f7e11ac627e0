//! `film denoise`.

use crate::checkpoint::picture_info;
use crate::denoise::{Halves, denoise};
use crate::outcome::Failure;
use crate::say::{say, tell_name};
use clap::Args;
use std::path::PathBuf;
use traylib_io::{PictureInfo, check_writable, load_film, save_picture};
use traylib_math::{Grid, Vec3};
use traylib_scene::Film;

/// A film to make a picture of that has less noise, and some bias.
#[derive(Args, Clone, Debug)]
pub struct DenoiseOptions {
    /// Film, as `--checkpoint` keeps it, of two samples a pixel or more
    #[arg(value_name = "FILM")]
    pub film: PathBuf,

    /// Picture to write: .exr, .hdr, .png, .tga or .pcx
    #[arg(value_name = "OUT")]
    pub output: PathBuf,
}

pub(super) fn denoise_film(options: &DenoiseOptions) -> Result<(), Failure> {
    let DenoiseOptions { film: file, output } = options;
    check_writable(output)?;
    let (film, about) = load_film(file)?;
    let halves = halves(&film).ok_or_else(|| {
        Failure::scene(format_args!(
            "{}: has no two halves to tell noise from; it takes two passes of `--sampler sobol`",
            file.display()
        ))
    })?;
    let info = picture_info(&about, film.passes());
    let integrator = format!("{}, denoised: biased", info.integrator);
    save_picture(output, &denoise(&halves), &PictureInfo { integrator, ..info })?;
    say("note: a denoised picture is biased: some of what looks like noise was none");
    tell_name(output)
}

/// The two sequences of a film, if both have passes.
fn halves(film: &Film) -> Option<Halves> {
    let (means, passes): (Vec<Grid<Vec3>>, Vec<u32>) = film
        .sequence_means()
        .map(|(mean, passes)| {
            (mean.map(|&light| Vec3::from(light.map(|band| band as f32))), passes)
        })
        .unzip();
    let pictures: [Grid<Vec3>; 2] = means.try_into().ok()?;
    let parts = [passes[0], passes[1]].map(|part| part as f32 / film.passes() as f32);
    parts.iter().all(|&part| part > 0.0).then_some(Halves { pictures, parts })
}
