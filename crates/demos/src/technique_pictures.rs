//! A picture of each bidirectional technique.

use crate::done::Done;
use crate::job::Job;
use crate::outcome::Failure;
use crate::say::tell_name;
use std::path::Path;
use traylib_integrators::Technique;
use traylib_io::{PictureInfo, save_picture};

/// Writes the pictures of all techniques into a folder that exists, as
/// `s2-t3-weighted.png` and `s2-t3-raw.png`, and prints their names.
///
/// # Errors
/// A picture cannot be written.
pub fn save_techniques(folder: &Path, job: &Job<'_>, done: &Done) -> Result<(), Failure> {
    for (&layer, picture) in &done.layers {
        let Technique { s, t, weighted } = Technique::of_layer(layer);
        let kind = if weighted { "weighted" } else { "raw" };
        let file = folder.join(format!("s{s}-t{t}-{kind}.png"));
        let integrator = format!("{} s={s} t={t} {kind}", job.program);
        let info = PictureInfo { integrator, ..done.info(job) };
        save_picture(&file, picture, &info)?;
        tell_name(&file)?;
    }
    Ok(())
}
