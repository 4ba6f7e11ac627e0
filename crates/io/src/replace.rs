//! Writing a file in one step.
//!
//! All that the programs write goes through here, pictures and text.

mod beside;
mod target;

use crate::Error;
use beside::Beside;
pub use beside::discard_unfinished;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::Path;
use target::Target;

/// Writes `bytes` to a file. Whoever reads the file meanwhile, or after a failure,
/// sees what was there before: it is written beside its place and renamed.
///
/// A file that is replaced hands on its permissions, and a link to a file stays
/// one. Pipes and character devices are written into, which waits for a reader as
/// they do.
///
/// # Errors
/// [`Error::Write`]: a folder, a file that may not be written, a link that leads
/// nowhere, or what the system says.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    replace(path, bytes).map_err(|cause| error(path, cause))
}

/// Whether [`write_file`] will be able to write there, as far as can be known before.
///
/// # Errors
/// As `write_file`.
pub fn check_file(path: &Path) -> Result<(), Error> {
    let check = || match Target::of(path)? {
        Target::Replace { place, before } => Beside::create(&place, before.as_ref()).map(drop),
        // To open a pipe would wait for its reader.
        Target::WriteInto => Ok(()),
    };
    check().map_err(|cause| error(path, cause))
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    match Target::of(path)? {
        Target::Replace { place, before } => {
            let mut beside = Beside::create(&place, before.as_ref())?;
            beside.file.write_all(bytes)?;
            beside.file.sync_all()?;
            // `beside` goes out of scope only afterwards: it finds nothing to remove.
            fs::rename(&beside.path, place)
        }
        Target::WriteInto => OpenOptions::new().write(true).open(path)?.write_all(bytes),
    }
}

fn error(path: &Path, cause: io::Error) -> Error {
    Error::Write { file: path.to_path_buf(), cause: cause.into() }
}

#[cfg(test)]
mod tests;
