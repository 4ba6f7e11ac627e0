//! The store of finished work on disk, so that an interrupted comparison goes on where it ended.
//!
//! Every piece of work has a key, a hash of all that decides its result; its numbers
//! lie in `KEY.json` and its pictures in `KEY-NAME.exr`. The numbers are written
//! last: where they are, the piece is whole.

use crate::picture::{Picture, double, single};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::{self, Debug, Write};
use std::path::{Path, PathBuf};
use traylib_io::{PictureInfo, Tone, check_file, load_exr, save_picture, write_file};
use traylib_math::Fnv;

/// A folder of finished work.
#[derive(Clone, Debug)]
pub struct Store {
    folder: PathBuf,
}

/// The reason why a piece of work cannot be kept.
#[derive(Debug)]
pub struct StoreError(String);

impl fmt::Display for StoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for StoreError {}

impl Store {
    /// A folder, made if need be.
    ///
    /// # Errors
    /// It cannot be made, or nothing can be written into it.
    pub fn open(folder: PathBuf) -> Result<Self, StoreError> {
        make_folder(&folder)?;
        let store = Self { folder };
        check_file(&store.file(0)).map_err(|error| StoreError(error.to_string()))?;
        Ok(store)
    }

    /// The numbers of a finished piece; `None` if it is not there, or not readable
    /// any more.
    pub fn numbers<T: DeserializeOwned>(&self, key: u64) -> Option<T> {
        let text = std::fs::read_to_string(self.file(key)).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// A picture of a finished piece.
    pub fn picture(&self, key: u64, name: &str) -> Option<Picture> {
        load_exr(&self.picture_file(key, name)).ok().map(|picture| double(&picture))
    }

    /// Keeps a piece of work.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn keep(
        &self,
        key: u64,
        numbers: &impl Serialize,
        pictures: &[(&str, &Picture)],
    ) -> Result<(), StoreError> {
        for (name, picture) in pictures {
            save_picture(&self.picture_file(key, name), &single(picture), &nameless())
                .map_err(|error| StoreError(error.to_string()))?;
        }
        write_json(&self.file(key), numbers)
    }

    fn file(&self, key: u64) -> PathBuf {
        self.folder.join(format!("{key:016x}.json"))
    }

    fn picture_file(&self, key: u64, name: &str) -> PathBuf {
        self.folder.join(format!("{key:016x}-{name}.exr"))
    }
}

/// The numbers beside a picture tell all about it.
fn nameless() -> PictureInfo {
    PictureInfo {
        exposure: 1.0,
        tone: Tone::Linear,
        program: concat!("TrayLib ", env!("CARGO_PKG_VERSION")).into(),
        integrator: String::new(),
        command: String::new(),
        scene: String::new(),
        seed: 0,
        spp: 0,
        rejected_samples: 0,
        frame: None,
    }
}

/// Writes numbers to a file, completely or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_json(path: &Path, numbers: &impl Serialize) -> Result<(), StoreError> {
    let text = serde_json::to_string_pretty(numbers).map_err(|e| cannot_write(path, &e))?;
    write_text(path, &text)
}

/// Writes text to a file, completely or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_text(path: &Path, text: &str) -> Result<(), StoreError> {
    write_file(path, text.as_bytes()).map_err(|error| StoreError(error.to_string()))
}

/// Makes a folder, and those it lies in, unless it is there.
///
/// # Errors
/// It cannot be made.
pub fn make_folder(folder: &Path) -> Result<(), StoreError> {
    std::fs::create_dir_all(folder)
        .map_err(|error| StoreError(format!("{}: cannot be made: {error}", folder.display())))
}

fn cannot_write(path: &Path, error: &dyn fmt::Display) -> StoreError {
    StoreError(format!("{}: cannot be written: {error}", path.display()))
}

/// FNV-1a of 64 bits (RFC 9923) of all that a value's debug text shows. No text of that
/// length is kept.
pub fn key_of(value: &impl Debug) -> u64 {
    let mut hash = Fnv::default();
    // A hash takes everything.
    let _ = write!(hash, "{value:?}");
    hash.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Grid;

    #[test]
    fn what_is_kept_is_found_again() {
        let folder = std::env::temp_dir().join(format!("traylib-store-{}", std::process::id()));
        let store = Store::open(folder.clone()).unwrap();
        let picture = Grid::filled(3, 2, [0.25, 1e-3, 7.0]);
        store.keep(5, &vec![1.5, 2.5], &[("mean", &picture)]).unwrap();
        assert_eq!(store.numbers::<Vec<f64>>(5), Some(vec![1.5, 2.5]));
        assert_eq!(store.numbers::<Vec<f64>>(6), None);
        let found = store.picture(5, "mean").unwrap();
        assert!((found.get(2, 1)[1] - 1e-3).abs() < 1e-9);
        std::fs::write(store.file(5), "[1.5, ").unwrap();
        assert_eq!(store.numbers::<Vec<f64>>(5), None);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn keys_tell_values_apart() {
        assert_eq!(key_of(&("a", 1)), key_of(&("a", 1)));
        assert_ne!(key_of(&("a", 1)), key_of(&("a", 2)));
        // FNV-1a of the text `"a"` with its quotes: the same tomorrow.
        assert_eq!(key_of(&"a"), 0xd427_2417_d7c7_7eea);
    }
}
