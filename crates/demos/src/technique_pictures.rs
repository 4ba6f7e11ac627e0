//! A picture of each bidirectional technique, and sheets of all.

use crate::done::Done;
use crate::job::Job;
use crate::outcome::Failure;
use crate::say::tell_name;
use crate::technique_sheet::sheet;
use std::path::Path;
use traylib_integrators::Technique;
use traylib_io::{PictureInfo, save_picture};
use traylib_math::Rgb;

/// Writes the pictures of all techniques into a folder that exists, as
/// `s2-t3-weighted.png` and `s2-t3-raw.png`, and prints their names; what is joined with
/// point lights by way of mirrors is in `s2-t3-mirror-weighted.png` and its like. All of them
/// together, each by the length of its paths and by s, are `all-weighted.png` and `all-raw.png`.
///
/// # Errors
/// A picture cannot be written.
pub fn save_techniques(folder: &Path, job: &Job<'_>, done: &Done) -> Result<(), Failure> {
    for (&layer, picture) in &done.layers {
        let Technique { s, t, by_mirror, weighted } = Technique::of_layer(layer);
        let kind = if weighted { "weighted" } else { "raw" };
        let (way, told) = if by_mirror { ("-mirror", " by way of a mirror") } else { ("", "") };
        let file = folder.join(format!("s{s}-t{t}{way}-{kind}.png"));
        let integrator = format!("{} s={s} t={t}{told} {kind}", job.program);
        let info = PictureInfo { integrator, ..done.info(job) };
        save_picture(&file, picture, &info)?;
        tell_name(&file)?;
    }
    save_sheets(folder, job, done)
}

fn save_sheets(folder: &Path, job: &Job<'_>, done: &Done) -> Result<(), Failure> {
    let info = done.info(job);
    // Dark grey, so that a black picture can be told from none.
    let between = Rgb::splat(0.05 / info.exposure);
    for (kind, is_weighted) in [("weighted", true), ("raw", false)] {
        let Some(picture) = sheet(&done.layers, is_weighted, between) else { continue };
        let file = folder.join(format!("all-{kind}.png"));
        let integrator = format!("{} all techniques {kind}", job.program);
        save_picture(&file, &picture, &PictureInfo { integrator, frame: None, ..info.clone() })?;
        tell_name(&file)?;
    }
    Ok(())
}
