//! The errors and warnings of this crate.

use crate::film_fault::{FilmDifference, FilmFault};
use crate::format_error::FormatError;
use crate::report::Report;
use crate::suggest::{nearest, quoted_list};
use std::fmt;
use std::path::PathBuf;

/// A file that cannot be read, makes no sense, or cannot be written.
///
/// The text begins without "error:", for a program to put before it. It may
/// have several lines.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Neither a file nor a built-in scene has this name.
    #[error("{}", unknown_scene(.name, .known))]
    UnknownScene {
        /// The name that was asked for.
        name: String,
        /// The names of the built-in scenes.
        known: &'static [&'static str],
    },
    /// A file cannot be read.
    #[error("{file}: cannot be read: {}", crate::source::why(.cause))]
    Read {
        /// The file.
        file: String,
        /// The system's reason.
        cause: std::io::Error,
    },
    /// A file of shapes that is not MGF makes no sense, or a material library that it names.
    #[error("{file}: {cause}")]
    Format {
        /// The file.
        file: String,
        /// Why, by its format.
        cause: FormatError,
    },
    /// An MGF file makes no sense.
    #[error(transparent)]
    Mgf(#[from] crate::mgf::Error),
    /// A scene of Mitsuba makes no sense.
    #[error(transparent)]
    Mitsuba(#[from] crate::mitsuba::Error),
    /// No file was named.
    #[error("no file is named")]
    NoFile,
    /// Several files that are not MGF.
    #[error("{}: only MGF files can be read together as one scene", .0.display())]
    SeveralFiles(PathBuf),
    /// A material of a file cannot be rendered.
    #[error("{file}: material: {cause}")]
    Material {
        /// The file.
        file: String,
        /// Why.
        cause: traylib_materials::Error,
    },
    /// A file's shapes make no scene.
    #[error("{file}: {cause}")]
    Model {
        /// The file.
        file: String,
        /// Why.
        cause: traylib_scene::Error,
    },
    /// Nothing in a file of shapes can be seen.
    #[error("{0}: it has no face that can be drawn")]
    NothingToSee(String),
    /// A file of shapes has no light.
    #[error("{}", unlit(.0))]
    Unlit(String),
    /// A scene file makes no sense; every place where it does not, with the
    /// lines shown.
    #[error("{0}")]
    Scene(Report),
    /// The ending of a picture's name says no format that is known.
    #[error(
        "{}: pictures are written as .png, .exr, .hdr, .tga or .pcx, and the name must end so",
        .0.display()
    )]
    PictureFormat(PathBuf),
    /// A scene is to be written where something is already.
    #[error("{}: is there already, with what may have been written by hand: `--force` replaces it", .0.display())]
    Exists(PathBuf),
    /// The ending of a scene's name says no format that scenes are written in.
    #[error("{}: scenes are written as .ron, and the name must end so", .0.display())]
    SceneName(PathBuf),
    /// A file cannot be written.
    #[error("{}: cannot be written: {cause}", .file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// The system's or the encoder's reason.
        cause: Box<dyn std::error::Error + Send + Sync>,
    },
    /// Two films are not of the same rendering.
    #[error(
        "{}: does not fit to {}: its {} is {}, not {}",
        .files[1].display(), .files[0].display(), .difference.name,
        .difference.words[1], .difference.words[0]
    )]
    FilmsDiffer {
        /// Both.
        files: [PathBuf; 2],
        /// The first setting in which they differ.
        difference: FilmDifference,
    },
    /// Two films have the same pass, whose light would count twice.
    #[error("{}: has pass {pass}, and so has {}", .files[1].display(), .files[0].display())]
    FilmsOverlap {
        /// Both.
        files: [PathBuf; 2],
        /// The number of the pass.
        pass: u64,
    },
    /// A film cannot be read.
    #[error("{}: cannot be read as a film: {cause}", .file.display())]
    ReadFilm {
        /// The file.
        file: PathBuf,
        /// Why.
        cause: FilmFault,
    },
    /// A picture cannot be read.
    #[error("{}: cannot be read as a picture: {cause}", .file.display())]
    ReadPicture {
        /// The file.
        file: PathBuf,
        /// The decoder's reason.
        cause: Box<dyn std::error::Error + Send + Sync>,
    },
    /// A picture can be read, and which of its channels are its light cannot be
    /// told.
    #[error(
        "{}: no picture found: wanted are channels R, G and B, or Y alone, of one layer or \
         prefix as beauty.R; it has {}",
        .file.display(),
        quoted_list(.channels.iter().map(String::as_str))
    )]
    NoLight {
        /// The file.
        file: PathBuf,
        /// The channels that it has, those of a named layer with its name.
        channels: Vec<String>,
    },
}

fn unlit(file: &str) -> String {
    format!(
        "{file}: nothing in it emits light\n  `trace` brings a light of its own; for the others \
         write a scene file with a lamp, as\n  (\n      camera: (…),  \
         // `trace` tells one that suits the file\n      objects: [(shape: Mesh(file: \"{file}\"))],\n      \
         lights: [Point(position: (0, 0, 2), intensity: (10, 10, 10))],\n  )"
    )
}

fn unknown_scene(name: &str, known: &[&str]) -> String {
    let guess = nearest(name, known.iter().copied())
        .map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    let list = quoted_list(known.iter().copied());
    format!("no file and no built-in scene is named `{name}`{guess}\n  built in: {list}")
}

/// Something in a file that was skipped or repaired. The scene can be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The file.
    pub file: String,
    /// The thing that was met, in words.
    pub what: String,
    /// The number of times it was met.
    pub count: u32,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.what)?;
        if self.count > 1 {
            write!(f, " ({} times)", self.count)?;
        }
        Ok(())
    }
}

impl From<&crate::mgf::Warning> for Warning {
    fn from(warning: &crate::mgf::Warning) -> Self {
        let file = warning.place.to_string();
        Self { file, what: warning.what(), count: warning.count }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_scene_gets_a_suggestion() {
        let error =
            Error::UnknownScene { name: "cornel".to_string(), known: &["cornell", "furnace"] };
        let expected = "no file and no built-in scene is named `cornel`; did you mean `cornell`?\
                        \n  built in: `cornell`, `furnace`";
        assert_eq!(error.to_string(), expected);
    }

    #[test]
    fn warnings_are_one_line_with_a_count() {
        let warning = |count| Warning { file: "a.3ds".into(), what: "light skipped".into(), count };
        assert_eq!(warning(1).to_string(), "a.3ds: light skipped");
        assert_eq!(warning(3).to_string(), "a.3ds: light skipped (3 times)");
    }
}
