//! A scene file and all it includes.

use super::place::Place;
use crate::Error;
use crate::report::{Problem, Report, SourceText};
use crate::ron_scene::locate::{Path, Step};
use crate::ron_scene::{Document, decode, syntax};
use crate::source::Location;
use std::io;
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

/// Reads a file and what it includes, each once; it comes last, and after what
/// it includes.
///
/// # Errors
/// [`Error::Read`] for the file itself, [`Error::Scene`] for everything else.
pub(crate) fn gather(root: &Location) -> Result<Vec<SceneFile>, Error> {
    let mut gathering = Gathering::default();
    let visited = gathering.visit(root);
    visited.map_err(|cause| Error::Read { file: root.to_string(), cause })?;
    if gathering.problems.is_empty() {
        Ok(gathering.files)
    } else {
        Err(Error::Scene(Report(gathering.problems)))
    }
}

#[derive(Default)]
struct Gathering {
    files: Vec<SceneFile>,
    problems: Vec<Problem>,
    /// Files begun, in the order in which they include one another.
    open: Vec<Location>,
    finished: Vec<Location>,
}

impl Gathering {
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
            Err(error) => self.problems.push(syntax::problem(&source, &error)),
        }
        self.finished.push(identity);
        Ok(())
    }

    fn visit_includes(&mut self, file: &SceneFile) {
        for (index, name) in file.document.include.iter().enumerate() {
            let place = file.place(Path::of("include").then(Step::Index(index)));
            let included = file.location.beside(name);
            if self.open.contains(&included.identity()) {
                let message = format!("`{name}` includes this file, directly or through others");
                self.problems.push(place.problem(message));
            } else if let Err(error) = self.visit(&included) {
                self.problems.push(place.problem(format!("`{name}` cannot be read: {error}")));
            }
        }
    }
}
