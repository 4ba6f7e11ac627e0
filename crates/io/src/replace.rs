//! Writing a file in one step.
//!
//! All that the programs write goes through here, pictures and text.

mod beside;
mod target;

use crate::Error;
use beside::Beside;
pub use beside::discard_unfinished;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
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
    replace(path, None, &mut |out| out.write_all(bytes)).map_err(|cause| error(path, cause))
}

/// [`write_file`] of what `write` writes, bit by bit, which need not fit into memory. A file
/// that is replaced becomes `kept`, if that is given.
///
/// # Errors
/// As `write_file`, or what `write` says.
pub(crate) fn write_file_by(
    path: &Path,
    kept: Option<&Path>,
    write: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Error> {
    replace(path, kept, write).map_err(|cause| error(path, cause))
}

/// Tells whether [`write_file`] will be able to write there, as far as can be known before.
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

fn replace(
    path: &Path,
    kept: Option<&Path>,
    write: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    match Target::of(path)? {
        Target::Replace { place, before } => {
            let beside = Beside::create(&place, before.as_ref())?;
            buffered(&beside.file, write)?;
            beside.file.sync_all()?;
            if let (Some(kept), Some(_)) = (kept, &before) {
                fs::rename(&place, kept)?;
            }
            // `beside` goes out of scope only afterwards: it finds nothing to remove.
            fs::rename(&beside.path, &place)?;
            sync_folder_of(&place);
            Ok(())
        }
        Target::WriteInto => buffered(&OpenOptions::new().write(true).open(path)?, write),
    }
}

/// Bytes that are handed to the system at once.
const BUFFER: usize = 1 << 20;

fn buffered(
    file: &File,
    write: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut buffer = BufWriter::with_capacity(BUFFER, file);
    write(&mut buffer)?;
    buffer.flush()
}

/// Makes a new name outlive a power cut, where the system can.
fn sync_folder_of(place: &Path) {
    let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
    // Not every system opens folders; the file itself is safe.
    let _ = File::open(folder.unwrap_or(Path::new("."))).and_then(|folder| folder.sync_all());
}

fn error(path: &Path, cause: io::Error) -> Error {
    Error::Write { file: path.to_path_buf(), cause: cause.into() }
}

#[cfg(test)]
mod tests;
