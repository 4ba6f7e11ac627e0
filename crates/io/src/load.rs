//! From a name to a scene that can be rendered.

use crate::builtin::builtin_names;
use crate::import;
use crate::source::Location;
use crate::{Error, LoadOptions, SceneSettings, Warning};
use std::path::{Path, PathBuf};
use traylib_scene::Scene;

/// A scene and what came with it.
#[derive(Debug)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// The settings for rendering that its file gives.
    pub settings: SceneSettings,
    /// The warnings: what was skipped or repaired.
    pub warnings: Vec<Warning>,
    /// The choices that were made because the file does not say it, such as a camera for an OBJ
    /// file: each a line that ends in what to write into a scene file.
    pub notes: Vec<String>,
    /// Whether it got a point light at the camera, as [`LoadOptions::headlight`] allows.
    pub headlight: bool,
    /// Its name: that of the built-in scene, or of the file without folder and
    /// ending.
    pub name: String,
}

/// Loads a scene in RON, glTF, OBJ, PLY, 3DS, MGF or Mitsuba's XML, or a built-in scene where no
/// file has this name.
///
/// # Errors
/// [`Error::UnknownScene`], [`Error::Read`], [`Error::Scene`] with every place
/// where a scene file makes no sense; [`Error::Format`], [`Error::Mgf`], [`Error::Mitsuba`],
/// [`Error::NothingToSee`] and [`Error::Unlit`] of the other formats.
pub fn load_scene(name_or_path: &str) -> Result<Loaded, Error> {
    load_scene_with(name_or_path, LoadOptions::default())
}

/// Does as [`load_scene`], but for some settings that replace those of the file.
///
/// # Errors
/// As `load_scene`.
pub fn load_scene_with(name_or_path: &str, options: LoadOptions<'_>) -> Result<Loaded, Error> {
    let imported = imported(name_or_path, options, false)?;
    let import::Imported { scene, mut settings, warnings, notes, headlight, parts: _ } = imported;
    settings.exposure = options.exposure.unwrap_or(settings.exposure);
    Ok(Loaded { scene, settings, warnings, notes, headlight, name: stem(name_or_path) })
}

fn imported(
    name_or_path: &str,
    options: LoadOptions<'_>,
    keep_parts: bool,
) -> Result<import::Imported, Error> {
    let location = find(name_or_path)?;
    match &location {
        Location::Disk(path) if import::is_model(path) => {
            import::import_whole(&location, options, keep_parts)
        }
        Location::Disk(_) | Location::BuiltIn(_) => {
            import::import(&import::gather(&location, options.root)?, options, keep_parts)
        }
    }
}

/// Loads the parts that a scene is built of, with warnings and notes.
///
/// # Errors
/// As [`load_scene`].
pub(crate) fn load_parts(
    name_or_path: &str,
    options: LoadOptions<'_>,
) -> Result<(import::SceneParts, Vec<Warning>, Vec<String>), Error> {
    let imported = imported(name_or_path, options, true)?;
    let import::Imported { warnings, notes, parts, .. } = imported;
    let parts = parts.ok_or_else(|| Error::NothingToSee(name_or_path.to_string()))?;
    Ok((parts, warnings, notes))
}

fn find(name: &str) -> Result<Location, Error> {
    if Path::new(name).is_file() {
        return Ok(Location::Disk(PathBuf::from(name)));
    }
    if builtin_names().contains(&name) {
        return Ok(Location::BuiltIn(format!("{name}.ron")));
    }
    Err(Error::UnknownScene { name: name.to_string(), known: builtin_names() })
}

fn stem(name: &str) -> String {
    Path::new(name).file_stem().map_or_else(|| name.to_string(), |s| s.to_string_lossy().into())
}

#[cfg(test)]
mod tests;
