//! The place of a scene file and its folder, of which all is written or nothing.

use super::ron::Written;
use crate::{Error, check_file, write_file};
use std::fs;
use std::path::{Path, PathBuf};

/// A scene file and the folder beside it.
pub(super) struct Target {
    scene: PathBuf,
    folder: PathBuf,
    name: String,
}

impl Target {
    /// The place for a scene file and its folder.
    pub(super) fn of(scene: &Path, replace: bool) -> Result<Self, Error> {
        let ending = scene.extension().unwrap_or_default();
        let Some(stem) = scene.file_stem().filter(|_| ending.eq_ignore_ascii_case("ron")) else {
            return Err(Error::SceneName(scene.to_path_buf()));
        };
        let name = format!("{}-files", stem.to_string_lossy());
        let folder = scene.with_file_name(&name);
        for path in [scene, &folder] {
            if path.symlink_metadata().is_ok() && !replace {
                return Err(Error::Exists(path.to_path_buf()));
            }
        }
        check_file(scene)?;
        Ok(Self { scene: scene.to_path_buf(), folder, name })
    }

    /// Returns the folder's name in the scene file.
    pub(super) fn folder_name(&self) -> &str {
        &self.name
    }

    /// Writes everything into a folder of its own, beside its place.
    pub(super) fn write(self, written: &Written<'_>) -> Result<Unfinished, Error> {
        let around = self.scene.with_file_name(format!(".{}-{}", self.name, std::process::id()));
        let unfinished = Unfinished { around, has_folder: written.has_files(), target: self };
        let folder = unfinished.folder();
        fs::create_dir_all(&folder).map_err(|cause| write_error(&folder, cause))?;
        for (name, bytes) in written.files() {
            let file = folder.join(name);
            let bytes = bytes.map_err(|cause| Error::Write { file: file.clone(), cause })?;
            write_file(&file, &bytes)?;
        }
        write_file(&unfinished.scene(), written.text.as_bytes())?;
        Ok(unfinished)
    }
}

/// A scene that is written, but not in its place. It is gone with the value.
pub(super) struct Unfinished {
    target: Target,
    around: PathBuf,
    has_folder: bool,
}

impl Unfinished {
    /// The file of the scene, for now.
    pub(super) fn scene(&self) -> PathBuf {
        self.around.join("scene.ron")
    }

    fn folder(&self) -> PathBuf {
        self.around.join(&self.target.name)
    }

    /// Puts everything in its place, the scene last, and names the files.
    pub(super) fn finish(self) -> Result<Vec<PathBuf>, Error> {
        let Target { scene, folder, .. } = &self.target;
        let mut files = vec![scene.clone()];
        let made = !folder.exists();
        if self.has_folder {
            let put = self.put_folder(&mut files);
            if put.is_err() && made {
                let _ = fs::remove_dir_all(folder);
            }
            put?;
        }
        let text = fs::read(self.scene()).map_err(|cause| write_error(scene, cause))?;
        let put = write_file(scene, &text);
        if put.is_err() && made {
            let _ = fs::remove_dir_all(folder);
        }
        put.map(|()| files)
    }

    fn put_folder(&self, files: &mut Vec<PathBuf>) -> Result<(), Error> {
        let to = &self.target.folder;
        let refused = |cause| write_error(to, cause);
        fs::create_dir_all(to).map_err(refused)?;
        let mut entries = fs::read_dir(self.folder()).map_err(refused)?;
        let mut names = entries.try_fold(Vec::new(), |mut names, entry| {
            names.push(entry?.file_name());
            Ok(names)
        });
        if let Ok(names) = &mut names {
            names.sort_unstable();
        }
        for name in names.map_err(refused)? {
            let place = to.join(&name);
            fs::rename(self.folder().join(&name), &place).map_err(refused)?;
            files.push(place);
        }
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.around);
    }
}

fn write_error(file: &Path, cause: std::io::Error) -> Error {
    Error::Write { file: file.to_path_buf(), cause: cause.into() }
}
