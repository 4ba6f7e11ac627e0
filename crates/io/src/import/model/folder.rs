//! Finds the pictures of a model.

use crate::source::Location;
use std::path::PathBuf;

/// Endings of pictures that can be read.
const ENDINGS: [&str; 9] = ["png", "bmp", "jpg", "jpeg", "tga", "gif", "pcx", "hdr", "exr"];

/// The files beside a model. Models name their pictures in the capitals of DOS,
/// and by formats that have been converted since.
pub(super) struct Folder {
    path: PathBuf,
    /// In order, so that the same is found everywhere.
    names: Vec<String>,
}

impl Folder {
    /// Lists the folder of a model; it is empty if it cannot be listed.
    pub(super) fn of(model: &Location) -> Self {
        let path = match model.folder() {
            Some(folder) => folder.to_path_buf(),
            None => return Self { path: PathBuf::new(), names: Vec::new() },
        };
        let entries = std::fs::read_dir(&path).into_iter().flatten().flatten();
        let mut names: Vec<String> =
            entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
        names.sort_unstable();
        Self { path, names }
    }

    /// Finds the file of this name, whatever the case; else one that differs in its
    /// ending alone.
    pub(super) fn find(&self, name: &str) -> Option<Location> {
        let exact = self.names.iter().find(|known| *known == name);
        let found = exact
            .or_else(|| self.names.iter().find(|known| known.eq_ignore_ascii_case(name)))
            .or_else(|| self.names.iter().find(|known| is_same_picture(known, name)))?;
        Some(Location::Disk(self.path.join(found)))
    }
}

fn is_same_picture(known: &str, wanted: &str) -> bool {
    let stem = |name: &str| name.rsplit_once('.').map_or(name.len(), |(stem, _)| stem.len());
    let same = known[..stem(known)].eq_ignore_ascii_case(&wanted[..stem(wanted)]);
    let ending = known.rsplit_once('.').map_or("", |(_, ending)| ending);
    same && ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_any_case_and_with_another_ending() {
        let names = ["WALL.png", "a.exe", "a.tga", "wall_dif.JPG"].map(String::from).to_vec();
        let folder = Folder { path: PathBuf::from("x"), names };
        let found = |name| match folder.find(name) {
            Some(Location::Disk(path)) => path.file_name().map(|n| n.to_str().unwrap().to_string()),
            _ => None,
        };
        assert_eq!(found("WALL_DIF.JPG").as_deref(), Some("wall_dif.JPG"));
        assert_eq!(found("wall.bmp").as_deref(), Some("WALL.png"));
        assert_eq!(found("A.GIF").as_deref(), Some("a.tga"));
        assert_eq!(found("b.gif"), None);
    }
}
