//! The files of results: whether they can be written, before the work, and then their writing.

use crate::job::Job;
use crate::outcome::Failure;
use crate::say::{STANDARD_OUTPUT, tell_name};
use std::path::{Path, PathBuf};
use traylib_io::{PictureInfo, PictureLayer, check_file, check_picture, save_picture_with};
use traylib_math::{Grid, Rgb};
use traylib_scene::Camera;

/// The files of the picture and the folder of what is beside it.
#[derive(Debug)]
pub(crate) struct Outputs<'a> {
    files: Vec<PathBuf>,
    folder: Option<&'a Path>,
    checkpoint: Option<&'a Path>,
    stats: Option<&'a Path>,
    wants_layers: bool,
}

impl<'a> Outputs<'a> {
    /// Makes the outputs of this job.
    pub(crate) fn of(job: &Job<'a>) -> Self {
        // A part of a rendering makes no picture.
        let folder = job.folder.filter(|_| job.makes_pictures());
        Self {
            files: outfiles(job),
            folder,
            checkpoint: job.options.keep.checkpoint.as_deref(),
            wants_layers: !job.options.aov.is_empty() && job.makes_pictures(),
            stats: job.options.stats.as_deref().filter(|file| *file != Path::new(STANDARD_OUTPUT)),
        }
    }

    /// Finds out before the work whether its result can be kept.
    ///
    /// # Errors
    /// It cannot.
    pub(crate) fn check(&self, camera: &Camera) -> Result<(), Failure> {
        if self.wants_layers && !self.files.iter().any(|file| is_exr(file)) {
            return Err(Failure::usage("--aov makes layers of an .exr picture; name one with -o"));
        }
        for file in &self.files {
            check_picture(file, camera.width(), camera.height())?;
        }
        for file in self.checkpoint.iter().chain(&self.stats) {
            check_file(file)?;
        }
        let Some(folder) = self.folder else { return Ok(()) };
        // What is not there yet will be made, where the first folder above it is.
        let above = folder.ancestors().find(|above| above.exists()).unwrap_or(Path::new(""));
        check_file(&above.join(".any")).map_err(|_| {
            Failure::output(format_args!(
                "{}: cannot be written to: {} takes no files",
                folder.display(),
                if above == Path::new("") { Path::new(".") } else { above }.display(),
            ))
        })
    }

    /// Makes the folder, if one is wanted.
    ///
    /// # Errors
    /// It cannot be made.
    pub(crate) fn make_folder(&self) -> Result<(), Failure> {
        let Some(folder) = self.folder else { return Ok(()) };
        std::fs::create_dir_all(folder).map_err(|error| {
            Failure::output(format_args!("{}: cannot be made: {error}", folder.display()))
        })
    }

    /// Writes the picture into every file and tells their names.
    ///
    /// # Errors
    /// A file cannot be written, or standard output takes no more.
    pub(crate) fn save(
        &self,
        picture: &Grid<Rgb>,
        info: &PictureInfo,
        layers: &[PictureLayer],
    ) -> Result<(), Failure> {
        for file in &self.files {
            save_picture_with(file, picture, info, layers)?;
            tell_name(file)?;
        }
        Ok(())
    }
}

fn is_exr(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("exr"))
}

fn outfiles(job: &Job<'_>) -> Vec<PathBuf> {
    if !job.wants_picture || !job.makes_pictures() {
        Vec::new()
    } else if job.options.outfile.is_empty() {
        vec![PathBuf::from(format!("{}.png", job.program))]
    } else {
        job.options.outfile.clone()
    }
}
