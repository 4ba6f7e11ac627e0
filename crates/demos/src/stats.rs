//! The contents of a file, as JSON.

use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::say::{say_line, write_json};
use std::path::{Path, PathBuf};
use traylib_io::inventory;

/// Writes the figures of the scene's files to `file`, `-` for standard output.
pub(crate) fn stats(options: &RenderOptions, file: &Path) -> Result<(), Failure> {
    let files: Vec<PathBuf> =
        [&options.scene].into_iter().chain(&options.more).map(PathBuf::from).collect();
    let (found, warnings) = inventory(&files, options.load_options())?;
    if !options.quiet {
        for warning in &warnings {
            say_line("warning", warning);
        }
    }
    write_json(file, &serde_json::to_value(found).map_err(Failure::output)?)
}
