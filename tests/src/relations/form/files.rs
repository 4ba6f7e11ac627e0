//! A scene as files, and back as what the library makes of them.

use super::ron::Entry;
use super::{picture, ron};
use crate::relations::scene::{DrawnScene, Picture};
use std::fs;
use std::io;
use std::path::Path;

/// A scene file and what has to lie beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Files {
    /// The scene file.
    pub text: String,
    /// Names and contents of the others.
    pub beside: Vec<(String, Vec<u8>)>,
    stem: String,
}

impl Files {
    /// The scene in our own format; shapes that only other formats know stand in
    /// files of theirs. All names begin with `stem`.
    pub fn of(scene: &DrawnScene, stem: &str) -> Self {
        let mut files = Self::empty(stem);
        let entries: Vec<Entry<'_>> = scene.objects.iter().map(Entry::Object).collect();
        files.text = ron::scene(scene, &entries, &mut files);
        files
    }

    pub(super) fn empty(stem: &str) -> Self {
        Self { text: String::new(), beside: Vec::new(), stem: stem.into() }
    }

    /// The name of the scene file.
    pub fn name(&self) -> String {
        format!("{}.ron", self.stem)
    }

    /// Adds a file and gives its name; the same content once.
    pub(super) fn add(&mut self, ending: &str, content: Vec<u8>) -> String {
        if let Some((name, _)) =
            self.beside.iter().find(|(name, old)| name.ends_with(ending) && *old == content)
        {
            return name.clone();
        }
        let name = format!("{}-{}.{ending}", self.stem, self.beside.len());
        self.beside.push((name.clone(), content));
        name
    }

    pub(super) fn add_picture(&mut self, picture: &Picture) -> String {
        let (ending, content) = picture::file(picture);
        self.add(ending, content)
    }

    /// Writes all into a folder; `head` goes before the text, as comments.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn save(&self, folder: &Path, head: &str) -> io::Result<()> {
        for (name, content) in &self.beside {
            fs::write(folder.join(name), content)?;
        }
        let head: Vec<String> = head.lines().map(|line| format!("// {line}\n")).collect();
        fs::write(folder.join(self.name()), head.concat() + &self.text)
    }

    /// Removes what [`save`](Self::save) wrote.
    pub fn remove(&self, folder: &Path) {
        for (name, _) in &self.beside {
            let _ = fs::remove_file(folder.join(name));
        }
        let _ = fs::remove_file(folder.join(self.name()));
    }
}
