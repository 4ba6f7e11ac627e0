//! Scenes of any format written as scene files in RON, to go on by hand.
//!
//! What a scene comes to is written, not what its file says: every shape by itself, materials as
//! they are rendered. Triangles stand in PLY files and pictures in EXR files in a folder beside.
//! The file reads back as the same scene: numbers are written so that what is made of them, as a
//! unit vector of a vector, has the same bits. It is read again before it is put in its place, and
//! what is not the same is told.

mod compare;
mod exact;
mod mesh;
mod number;
mod picture;
mod ron;
mod surface;
mod target;

use crate::import::{self, SceneParts};
use crate::{Error, Headlight, LoadOptions, Warning};
use ron::Written;
use std::path::{Path, PathBuf};
use target::Target;

/// The files that were written.
#[derive(Debug)]
pub struct Converted {
    /// The files: that of the scene first.
    pub files: Vec<PathBuf>,
    /// The warnings about the scene, and about what does not read back as it was.
    pub warnings: Vec<Warning>,
    /// The choices that were made because the file does not say it.
    pub notes: Vec<String>,
}

/// Reads a scene of any format, or one that is built in, and writes it as `output` in RON, with
/// meshes and pictures in a folder beside it, `NAME-files`. A file without any light gets one at
/// the camera. Files that are there already are replaced only if `replace` says so.
///
/// # Errors
/// Those of [`load_scene_with`](crate::load_scene_with); [`Error::Exists`], [`Error::Write`], by
/// which nothing is written.
pub fn convert_scene(
    input: &str,
    output: &Path,
    options: LoadOptions<'_>,
    replace: bool,
) -> Result<Converted, Error> {
    let target = Target::of(output, replace)?;
    let options = LoadOptions { headlight: Headlight::WithoutLight, ..options };
    let (parts, mut warnings, notes) = crate::load::load_parts(input, options)?;
    let written = Written::of(&parts, target.folder_name());
    let unfinished = target.write(&written)?;
    warnings.extend(differences(&parts, &unfinished.scene(), output)?);
    Ok(Converted { files: unfinished.finish()?, warnings, notes })
}

/// Reads what was written, and tells what is not the same.
fn differences(parts: &SceneParts, written: &Path, name: &Path) -> Result<Option<Warning>, Error> {
    let options = LoadOptions { headlight: Headlight::Never, ..LoadOptions::default() };
    let again = crate::load::load_parts(&written.to_string_lossy(), options);
    let (again, ..) = again?;
    let count = compare::differences(parts, &again);
    let what = "number that reads back otherwise in its last digits".to_string();
    let file = name.display().to_string();
    Ok((count > 0).then_some(Warning { file, what, count }))
}

pub(crate) use import::{PartObject, PartSky};

#[cfg(test)]
mod tests;
