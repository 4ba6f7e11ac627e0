//! A picture of each bidirectional technique.

use crate::outcome::Failure;
use crate::run::{Done, Job};
use std::path::Path;
use traylib_integrators::Technique;
use traylib_io::save_picture;

/// Writes the pictures of all techniques into a folder, as
/// `s2-t3-weighted.png` and `s2-t3-raw.png`.
///
/// # Errors
/// The folder cannot be made, or a picture not written.
pub fn save_techniques(folder: &Path, job: &Job<'_>, done: &Done) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::output(format_args!("{}: {error}", folder.display())))?;
    let passes = done.rendering.film.passes();
    for (&layer, image) in &done.rendering.layers {
        let Technique { s, t, weighted } = Technique::of_layer(layer);
        let kind = if weighted { "weighted" } else { "raw" };
        let file = folder.join(format!("s{s}-t{t}-{kind}.png"));
        save_picture(&file, &image.mean_over(passes), &done.info(job)).map_err(Failure::output)?;
    }
    Ok(())
}
