//! From a name to a scene that can be rendered.

use crate::builtin::builtin_names;
use crate::import;
use crate::source::Location;
use crate::{Error, Warning};
use std::path::{Path, PathBuf};
use traylib_scene::Scene;

/// What a scene file says about rendering it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneSettings {
    /// Samples per pixel, at least one.
    pub spp: u32,
    /// Factor on radiance in 8-bit pictures, positive.
    pub exposure: f32,
}

/// What the caller wants otherwise than the file says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LoadOptions {
    /// Width and height of the picture in pixels.
    pub resolution: Option<(u32, u32)>,
}

/// A scene and what came with it.
#[derive(Debug)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// What its file says about rendering it.
    pub settings: SceneSettings,
    /// What was skipped or repaired.
    pub warnings: Vec<Warning>,
    /// Its name: that of the built-in scene, or of the file without folder and
    /// ending.
    pub name: String,
}

/// Loads a scene file, or a built-in scene where no file has this name.
///
/// # Errors
/// [`Error::UnknownScene`], [`Error::Read`], [`Error::MeshAsScene`], or
/// [`Error::Scene`] with every place where the scene makes no sense.
pub fn load_scene(name_or_path: &str) -> Result<Loaded, Error> {
    load_scene_with(name_or_path, LoadOptions::default())
}

/// [`load_scene`] with some things otherwise than the file says.
///
/// # Errors
/// As `load_scene`.
pub fn load_scene_with(name_or_path: &str, options: LoadOptions) -> Result<Loaded, Error> {
    let location = find(name_or_path)?;
    let files = import::gather(&location)?;
    let import::Imported { scene, settings, warnings } = import::import(&files, options)?;
    Ok(Loaded { scene, settings, warnings, name: stem(name_or_path) })
}

fn find(name: &str) -> Result<Location, Error> {
    let path = Path::new(name);
    if path.is_file() {
        let ends = |wanted| path.extension().is_some_and(|e| e.eq_ignore_ascii_case(wanted));
        if ends("3ds") {
            return Err(Error::MeshAsScene(name.to_string()));
        }
        if ends("mgf") {
            return Err(Error::MgfAsScene(name.to_string()));
        }
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
