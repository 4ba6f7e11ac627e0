//! The target of a write: what is there already.

use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The way to write to a path.
pub(super) enum Target {
    /// A file takes this place, no link, and that of the one before, if there is one.
    Replace { place: PathBuf, before: Option<Metadata> },
    /// The target takes bytes and cannot be replaced.
    WriteInto,
}

impl Target {
    /// Finds the way to write to this path, links followed.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        let found = match fs::metadata(path) {
            Ok(found) => found,
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            Err(_) if path.is_symlink() => {
                return Err(io::Error::new(
                    ErrorKind::NotFound,
                    "it is a link that leads to no file",
                ));
            }
            Err(_) if !is_in_a_folder(path) => {
                return Err(io::Error::new(ErrorKind::NotFound, "there is no such folder"));
            }
            Err(_) => return Ok(Self::Replace { place: path.to_path_buf(), before: None }),
        };
        if found.is_dir() {
            return Err(io::Error::new(ErrorKind::IsADirectory, "it is a folder"));
        }
        if found.permissions().readonly() {
            return Err(io::Error::new(ErrorKind::PermissionDenied, "it is read-only"));
        }
        if takes_bytes(&found) {
            return Ok(Self::WriteInto);
        }
        if !found.is_file() {
            return Err(io::Error::other("it is neither a file nor a pipe"));
        }
        // A rename asks only the folder; the file's own owner, and the system where
        // it mistrusts a link, are asked by opening it.
        OpenOptions::new().write(true).open(path)?;
        Ok(Self::Replace { place: fs::canonicalize(path)?, before: Some(found) })
    }
}

/// Tells whether the folder is there that the path names, if it names one.
fn is_in_a_folder(path: &Path) -> bool {
    path.parent().is_none_or(|folder| folder.as_os_str().is_empty() || folder.is_dir())
}

#[cfg(unix)]
fn takes_bytes(found: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    found.file_type().is_fifo() || found.file_type().is_char_device()
}

#[cfg(not(unix))]
fn takes_bytes(_: &Metadata) -> bool {
    false
}
