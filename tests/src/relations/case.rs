//! Scenes on disk: caught once, kept for ever. Our own files back into plain data.

mod read;

use crate::relations::scene::DrawnScene;
use std::fs;
use std::path::{Path, PathBuf};

/// A scene file with what its first comments say.
#[derive(Clone, Debug)]
pub struct Case {
    /// The name of the file.
    pub name: String,
    /// The scene.
    pub drawn: DrawnScene,
    /// The right mean over the picture, where it is known: `// right: 0.5`.
    pub right: Option<Known>,
}

/// A number as it was written down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// The number.
    pub mean: f64,
    /// The part of it by which the last digit may be wrong.
    pub margin: f64,
}

impl Known {
    /// Half a unit of the last digit is what may be wrong; nothing of a zero.
    fn read(text: &str) -> Option<Self> {
        let mean: f64 = text.parse().ok()?;
        let digits = text.split_once('.').map_or(0, |(_, digits)| digits.len());
        let half = 0.5 / 10.0_f64.powf(digits as f64);
        Some(Self { mean, margin: if mean == 0.0 { 0.0 } else { half / mean } })
    }
}

impl Case {
    /// Reads a file. Comments before the scene may say `max-depth: 3` and
    /// `right: 0.5`.
    ///
    /// # Errors
    /// In words, with the file.
    pub fn read(path: &Path) -> Result<Self, String> {
        let failed = |why: String| format!("{}: {why}", path.display());
        let text = fs::read_to_string(path).map_err(|error| failed(error.to_string()))?;
        let said = |key: &str| {
            let head = text.lines().map_while(|line| line.strip_prefix("//"));
            head.filter_map(|line| line.trim().strip_prefix(key))
                .find_map(|rest| rest.strip_prefix(": "))
        };
        let mut drawn = read::scene(&text, path).map_err(failed)?;
        drawn.max_depth = said("max-depth").and_then(|depth| depth.parse().ok());
        let right = said("right").and_then(Known::read);
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Self { name, drawn, right })
    }
}

/// All scene files of a folder, by name.
///
/// # Errors
/// If it cannot be read.
pub fn files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut paths = entries.collect::<std::io::Result<Vec<PathBuf>>>()?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ron"));
    paths.sort();
    Ok(paths)
}
