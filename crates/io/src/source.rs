//! Sources of files: a folder on disk, or the set compiled in.

use crate::builtin;
use crate::suggest::nearest;
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::string::FromUtf8Error;
use std::{fmt, fs, io};

/// Names of a folder that are looked at for one that was meant.
const MOST_ENTRIES: usize = 10_000;

/// A file that may be read.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Location {
    /// On disk.
    Disk(PathBuf),
    /// Compiled in, named relative to the folder of built-in scenes.
    BuiltIn(String),
}

impl Location {
    pub(crate) fn read(&self) -> io::Result<Cow<'static, [u8]>> {
        match self {
            Self::Disk(path) => read_file(path).map(Cow::Owned),
            Self::BuiltIn(name) => builtin::file(name)
                .map(Cow::Borrowed)
                .ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "no such built-in file")),
        }
    }

    pub(crate) fn read_text(&self) -> io::Result<String> {
        let refused = |why: String| io::Error::new(io::ErrorKind::InvalidData, why);
        let bytes = self.read()?.into_owned();
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Err(refused("it is UTF-16 text: save it as UTF-8".to_string()));
        }
        let text = String::from_utf8(bytes).map_err(|error| refused(not_text(&error)))?;
        // The byte order mark, which some editors put in front.
        Ok(text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text))
    }

    /// The file that a scene file here calls `file`. All built-in scene files
    /// stand in one folder.
    pub(crate) fn beside(&self, file: &str) -> Self {
        match self {
            Self::Disk(path) => Self::Disk(path.parent().unwrap_or(Path::new("")).join(file)),
            Self::BuiltIn(_) => Self::BuiltIn(file.to_string()),
        }
    }

    /// The folder that a file on disk is in, by a name that can be opened.
    pub(crate) fn folder(&self) -> Option<&Path> {
        match self {
            Self::Disk(path) => match path.parent() {
                // Of a file that is named without a folder.
                Some(folder) if folder.as_os_str().is_empty() => Some(Path::new(".")),
                folder => folder,
            },
            Self::BuiltIn(_) => None,
        }
    }

    /// Advises what to do where there is no such file, `name` being how it is called in a text.
    pub(crate) fn advice(&self, name: &str) -> Option<String> {
        let Self::Disk(path) = self else { return None };
        if path.exists() {
            return None;
        }
        if name.contains(|c: char| c == '\\' || c.is_control()) {
            return Some(
                "folders are written with `/`: in quotes, `\\` begins a special character".into(),
            );
        }
        let names = fs::read_dir(self.folder()?).ok()?.take(MOST_ENTRIES).flatten();
        let mut names: Vec<String> =
            names.filter_map(|entry| entry.file_name().into_string().ok()).collect();
        names.sort_unstable();
        let near = nearest(path.file_name()?.to_str()?, names.iter().map(String::as_str))?;
        let folder =
            name.rsplit_once('/').map_or_else(String::new, |(folder, _)| format!("{folder}/"));
        Some(format!("did you mean `{folder}{near}`?"))
    }

    /// Returns what is the same for all names of one file.
    pub(crate) fn identity(&self) -> Self {
        match self {
            Self::Disk(path) => Self::Disk(path.canonicalize().unwrap_or_else(|_| path.clone())),
            Self::BuiltIn(_) => self.clone(),
        }
    }
}

/// `folder/name` with `.` and `..` resolved by the text alone.
pub(crate) fn joined(folder: &Path, name: &str) -> PathBuf {
    let mut path = folder.to_path_buf();
    for part in name.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                path.pop();
            }
            _ => path.push(part),
        }
    }
    path
}

/// Says why the system refuses, without its numbers.
#[expect(clippy::wildcard_enum_match_arm, reason = "the system's open set")]
pub(crate) fn why(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_string(),
        io::ErrorKind::IsADirectory => "it is a folder".to_string(),
        io::ErrorKind::PermissionDenied => "reading it is not permitted".to_string(),
        _ => {
            let text = error.to_string();
            text.split(" (os error").next().unwrap_or_default().to_string()
        }
    }
}

/// Says in which line text is not UTF-8.
fn not_text(error: &FromUtf8Error) -> String {
    let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
    let line = before.split(|&byte| byte == b'\n').count();
    format!("it is not UTF-8 text, the first time in line {line}: save it as UTF-8")
}

/// A file to its end, which a device or a pipe that a scene names might not have.
fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let kind = fs::metadata(path)?.file_type();
    if kind.is_file() || kind.is_dir() {
        return fs::read(path);
    }
    Err(io::Error::new(io::ErrorKind::InvalidInput, "it is a device or a pipe, not a file"))
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Disk(path) => path.display().fmt(f),
            Self::BuiltIn(name) => write!(f, "built-in {name}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_looked_up_beside_the_one_that_names_them() {
        let disk = Location::Disk(PathBuf::from("rooms/a.ron")).beside("models/x.3ds");
        assert_eq!(disk, Location::Disk(PathBuf::from("rooms/models/x.3ds")));
        let bare = Location::Disk(PathBuf::from("a.ron"));
        assert_eq!(bare.folder(), Some(Path::new(".")));
        let bare = bare.beside("b.ron");
        assert_eq!(bare, Location::Disk(PathBuf::from("b.ron")));
        assert!(Location::BuiltIn("cornell.ron".into()).beside("spheres.ron").read().is_ok());
    }

    #[cfg(unix)]
    #[test]
    fn what_has_no_end_is_refused() {
        let error = Location::Disk(PathBuf::from("/dev/zero")).read().unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidInput);
    }
}
