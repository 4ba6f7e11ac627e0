//! The file that is written before it takes another's place.

use std::fs::{self, File, Metadata, OpenOptions};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A new file in the same folder, `.NAME.XXXXXXXXXXXXXXXX.part` with sixteen digits
/// that nobody can foresee, removed again when dropped.
///
/// It is locked as long as its program lives, however that ends. So whoever writes to
/// the same place next can tell what a killed run has left, which it removes, from
/// what another run is writing.
pub(super) struct Beside {
    pub(super) file: File,
    pub(super) path: PathBuf,
}

/// The unfinished files of this program that are there now.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file that was not there, no link either; at no time is it there and not listed.
fn create_new(path: &Path) -> io::Result<File> {
    let mut unfinished = unfinished();
    let file = OpenOptions::new().write(true).create_new(true).open(path)?;
    unfinished.push(path.to_path_buf());
    Ok(file)
}

/// Removes what is being written, for a program that ends at once: what threads are
/// about to do then is not done, and nothing is dropped.
pub fn discard_unfinished() {
    for path in unfinished().drain(..) {
        let _ = fs::remove_file(path);
    }
}

/// More than a few tries fail only where locks do not work.
const TRIES: usize = 16;

impl Beside {
    /// Makes one for a file at `place`, with the permissions of the file that it will
    /// replace, and removes those that were left behind there.
    pub(super) fn create(place: &Path, before: Option<&Metadata>) -> io::Result<Self> {
        let stem = stem(place)?;
        remove_abandoned(place, &stem);
        for _ in 0..TRIES {
            let path = place.with_file_name(format!("{stem}{:016x}{ENDING}", random()));
            let file = match create_new(&path) {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
                made => made?,
            };
            // A folder without locks is as good: nothing is removed there.
            let _ = file.try_lock();
            let beside = Self { file, path };
            // Another run may have met it before it was locked.
            if fs::symlink_metadata(&beside.path).is_err() {
                continue;
            }
            // Before the first byte is in it.
            before.map_or(Ok(()), |before| resemble(&beside.file, before))?;
            return Ok(beside);
        }
        Err(io::Error::other("no file can be kept beside it"))
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // After a rename there is nothing left to remove.
        let _ = fs::remove_file(&self.path);
        unfinished().retain(|path| *path != self.path);
    }
}

const DIGITS: usize = 16;
const ENDING: &str = ".part";

/// Returns the beginning of the names that stand for a file at `place`. Names have a largest
/// length, so no more than 40 characters of the file's own are in it; files that share them tidy up
/// for one another.
fn stem(place: &Path) -> io::Result<String> {
    let name = place.file_name().ok_or(ErrorKind::InvalidInput)?.to_string_lossy();
    Ok(format!(".{}.", name.chars().take(40).collect::<String>()))
}

fn random() -> u64 {
    RandomState::new().build_hasher().finish()
}

/// Removes what runs have left that were killed: files of such names that nobody
/// holds locked. What cannot be looked at is left alone.
fn remove_abandoned(place: &Path, stem: &str) {
    let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
    let Ok(entries) = fs::read_dir(folder.unwrap_or(Path::new("."))) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let is_ours = name.to_str().is_some_and(|name| is_temporary(name, stem));
        // No link, and no pipe, which would have to be waited for.
        if is_ours && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            remove_if_unlocked(&entry.path());
        }
    }
}

fn is_temporary(name: &str, stem: &str) -> bool {
    name.strip_prefix(stem)
        .and_then(|rest| rest.strip_suffix(ENDING))
        .is_some_and(|digits| digits.len() == DIGITS && digits.bytes().all(is_digit))
}

fn is_digit(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9' | b'a'..=b'f')
}

fn remove_if_unlocked(path: &Path) {
    // Ours can be written by whoever may write the file itself.
    if let Ok(file) = OpenOptions::new().write(true).open(path)
        && file.try_lock().is_ok()
    {
        let _ = fs::remove_file(path);
    }
}

/// Gives a file the permissions of another, and its owners as far as the system lets.
fn resemble(file: &File, other: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        // Only the group may be changed by everybody, to one that they are in.
        if fchown(file, Some(other.uid()), Some(other.gid())).is_err() {
            let _ = fchown(file, None, Some(other.gid()));
        }
    }
    file.set_permissions(other.permissions())
}
