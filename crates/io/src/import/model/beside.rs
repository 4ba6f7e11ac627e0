//! Files that a model names: its pictures, material libraries and buffers.
//!
//! They may come from the folder of the model, or from a wider one that the caller names, and
//! from nowhere else.

use super::folder::Folder;
use crate::load_options::LoadOptions;
use crate::source::{Location, joined};
use std::path::{Path, PathBuf};

/// The folders in which a model looks for files.
pub(super) struct Beside {
    folder: Folder,
    /// The folder of the model.
    path: PathBuf,
    /// The canonical path of the folder that no file may be outside of.
    root: PathBuf,
}

impl Beside {
    pub(super) fn of(model: &Location, options: LoadOptions<'_>) -> Self {
        let path = model.folder().unwrap_or(Path::new("")).to_path_buf();
        let path = path.canonicalize().unwrap_or(path);
        let root = options.root.map(|root| root.canonicalize().unwrap_or_else(|_| root.into()));
        // Of a model in another folder than the caller's, its own.
        let root = root.filter(|root| path.starts_with(root)).unwrap_or_else(|| path.clone());
        Self { folder: Folder::of(model), path, root }
    }

    /// Finds the file of exactly this name, with `/` between folders. It may begin at the root of
    /// all files, as some writers have it, and must lie within all the same.
    pub(super) fn exactly(&self, name: &str) -> Option<Location> {
        if name.contains('\0') {
            return None;
        }
        // Nothing outside is touched, not even to see whether it exists.
        let path = if is_from_root(name) {
            joined(&self.root, Path::new(name).strip_prefix(&self.root).ok()?.to_str()?)
        } else {
            joined(&self.path, name)
        };
        let inside = path.starts_with(&self.root).then_some(path)?;
        let path = inside.canonicalize().ok()?;
        (path.starts_with(&self.root) && path.is_file()).then_some(Location::Disk(path))
    }

    /// Finds the file of exactly this name, else one beside the model whose name differs in case or
    /// in its ending: models carry folders of the machines on which they were made.
    pub(super) fn find(&self, name: &str) -> Option<Location> {
        let name = name.replace('\\', "/");
        let last = name.rsplit('/').next().unwrap_or_default();
        self.exactly(&name).or_else(|| self.folder.find(last).filter(|_| !last.is_empty())).filter(
            |location| match location {
                Location::Disk(path) => {
                    path.canonicalize().is_ok_and(|path| path.starts_with(&self.root))
                }
                Location::BuiltIn(_) => false,
            },
        )
    }
}

/// Tells whether a name begins at the root of all files.
pub(super) fn is_from_root(name: &str) -> bool {
    name.starts_with('/') || Path::new(name).is_absolute()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn nothing_outside_of_the_folder_is_found() {
        let folder = std::env::temp_dir().join(format!("traylib-beside-{}", std::process::id()));
        let inner = folder.join("model/pictures");
        fs::create_dir_all(&inner).unwrap();
        for name in ["secret.png", "model/a.obj", "model/Wall.PNG", "model/pictures/b.png"] {
            fs::write(folder.join(name), "").unwrap();
        }
        let model = Location::Disk(folder.join("model/a.obj"));
        let found = |options: LoadOptions<'_>, name: &str| {
            let found = Beside::of(&model, options).find(name);
            found.map(|location| location.to_string().rsplit('/').next().unwrap().to_string())
        };
        let usual = LoadOptions::default();
        assert_eq!(found(usual, "pictures/b.png").as_deref(), Some("b.png"));
        assert_eq!(found(usual, r"C:\work\wall.png").as_deref(), Some("Wall.PNG"));
        assert_eq!(found(usual, "wall.jpg").as_deref(), Some("Wall.PNG"));
        for outside in ["../secret.png", "pictures/../../secret.png", "/etc/hostname", "", "b.png"]
        {
            assert_eq!(found(usual, outside), None, "{outside}");
        }
        let inner = inner.canonicalize().unwrap();
        let whole = |name: &str| inner.join(name).to_str().unwrap().to_string();
        assert_eq!(found(usual, &whole("b.png")).as_deref(), Some("b.png"));
        assert_eq!(found(usual, &whole("../../secret.png")), None);
        let wider = LoadOptions { root: Some(&folder), ..usual };
        assert_eq!(found(wider, "../secret.png").as_deref(), Some("secret.png"));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(folder.join("secret.png"), folder.join("model/link.png"))
                .unwrap();
            assert_eq!(found(usual, "link.png"), None);
        }
        fs::remove_dir_all(&folder).unwrap();
    }
}
