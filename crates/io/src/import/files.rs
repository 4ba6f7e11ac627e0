//! A scene file and all it includes.

use super::place::Place;
use crate::Error;
use crate::locate::{Path, Step};
use crate::report::{Problem, Problems, SourceText};
use crate::ron_scene::{Document, decode, syntax};
use crate::source::{Location, joined, why};
use crate::suggest::shown;
use std::collections::HashSet;
use std::io;
use std::path::{Path as FilePath, PathBuf};
use std::sync::Arc;

/// A scene file that has been read.
#[derive(Debug)]
pub(crate) struct SceneFile {
    pub(super) location: Location,
    pub(super) source: Arc<SourceText>,
    pub(super) document: Document,
}

impl SceneFile {
    pub(super) fn place(&self, path: Path) -> Place {
        Place { source: Arc::clone(&self.source), path }
    }
}

/// Includes within includes. Each takes some of the stack, and no scene needs so many.
const MOST_DEPTH: usize = 64;

/// Reads a file and what it includes, each once; it comes last, and after what
/// it includes. Included files may not leave the folder `widened`, or that of the file.
///
/// # Errors
/// [`Error::Read`] for the file itself, [`Error::Scene`] for everything else.
pub(crate) fn gather(root: &Location, widened: Option<&FilePath>) -> Result<Vec<SceneFile>, Error> {
    let mut gathering = Gathering::new(widened.or_else(|| root.folder()));
    let visited = gathering.visit(root);
    visited.map_err(|cause| Error::Read { file: root.to_string(), cause })?;
    if gathering.problems.is_empty() {
        Ok(gathering.files)
    } else {
        Err(Error::Scene(gathering.problems.into_report()))
    }
}

struct Gathering {
    /// The canonical path of the folder that holds included files; `None` of built-in scenes.
    folder: Option<PathBuf>,
    files: Vec<SceneFile>,
    problems: Problems,
    /// Files begun, in the order in which they include one another.
    open: Vec<Location>,
    finished: HashSet<Location>,
}

impl Gathering {
    fn new(folder: Option<&FilePath>) -> Self {
        let one_name = |folder: &FilePath| folder.canonicalize().unwrap_or_else(|_| folder.into());
        Self {
            folder: folder.map(one_name),
            files: Vec::new(),
            problems: Problems::default(),
            open: Vec::new(),
            finished: HashSet::new(),
        }
    }

    fn visit(&mut self, location: &Location) -> io::Result<()> {
        let identity = location.identity();
        if self.finished.contains(&identity) {
            return Ok(());
        }
        let source = SourceText { name: location.to_string(), text: location.read_text()? };
        let source = Arc::new(source);
        match decode(&source.text) {
            Ok(document) => {
                let file = SceneFile { location: location.clone(), source, document };
                self.open.push(identity.clone());
                self.visit_includes(&file);
                self.open.pop();
                self.files.push(file);
            }
            // What an included file holds is shown only if it is meant to be a scene.
            Err(_) if !self.open.is_empty() && !syntax::is_begun(&source.text) => {
                let why = "it is no scene file, which would begin with `(`";
                return Err(io::Error::new(io::ErrorKind::InvalidData, why));
            }
            Err(error) => self.problems.push(syntax::problem(&source, &error)),
        }
        self.finished.insert(identity);
        Ok(())
    }

    fn visit_includes(&mut self, file: &SceneFile) {
        for (index, name) in file.document.include.iter().enumerate() {
            let place = file.place(Path::of("include").then(Step::Index(index)));
            if let Err(problem) = self.include(&file.location, name, &place) {
                self.problems.push(problem);
            }
        }
    }

    fn include(&mut self, from: &Location, name: &str, place: &Place) -> Result<(), Problem> {
        let shown = shown(name);
        if self.open.len() >= MOST_DEPTH {
            let message =
                format!("`{shown}` is the {MOST_DEPTH}th file that the one before includes");
            return Err(place.problem(message).with_help("name the files in fewer steps"));
        }
        if let Some(folder) = self.left_by(from, name) {
            let message = format!("`{shown}` is outside of {}", folder.display());
            let help = "files may be included from the folder of the scene, or from that which \
                        `--root` names";
            return Err(place.problem(message).with_help(help));
        }
        let included = from.beside(name);
        if self.open.contains(&included.identity()) {
            let message = format!("`{shown}` includes this file, directly or through others");
            return Err(place.problem(message));
        }
        self.visit(&included).map_err(|error| {
            let message = format!("`{shown}` cannot be read: {}", why(&error));
            place.problem(message).with_help_if_any(included.advice(name))
        })
    }

    /// The folder that a file is not in, if it should be. Nothing outside is touched, but
    /// by what a link inside leads to.
    fn left_by(&self, from: &Location, name: &str) -> Option<&FilePath> {
        let folder = self.folder.as_deref()?;
        let Location::Disk(from) = from.identity() else { return None };
        let around = if FilePath::new(name).is_absolute() { None } else { from.parent() };
        let path = joined(around.unwrap_or(FilePath::new("/")), name);
        let is_inside = |path: &FilePath| path.starts_with(folder);
        let stays = is_inside(&path) && path.canonicalize().map_or(true, |path| is_inside(&path));
        (!stays).then_some(folder)
    }
}
