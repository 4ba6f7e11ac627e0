//! Files on disk: each is read once, and includes stay below the root.

use super::budget::Budget;
use super::error::shown;
use super::source::Source;
use super::{Cause, Error, FileFault, Options};
use crate::source::joined;
use std::collections::HashMap;
use std::fs;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Work to look for a file, in bytes of text.
const SEARCH_COST: u64 = 8192;
/// Memory of an entry in a table beside its name, at most.
const ENTRY: usize = 256;

/// All files read so far.
pub(super) struct Files {
    root: PathBuf,
    sources: Vec<Rc<Source>>,
    by_path: HashMap<PathBuf, usize>,
    /// The file that a name means in an including file, by their numbers.
    included: HashMap<(usize, String), usize>,
    bytes_left: u64,
    max_bytes: u64,
    max_line: usize,
}

impl Files {
    pub(super) fn new(options: &Options, files: &[PathBuf]) -> Result<Self, Error> {
        let root = match (&options.root, files.first()) {
            (Some(root), _) => canonical(root)?,
            (None, Some(first)) => {
                canonical(first)?.parent().map(PathBuf::from).unwrap_or_default()
            }
            (None, None) => PathBuf::new(),
        };
        Ok(Self {
            root,
            sources: Vec::new(),
            by_path: HashMap::new(),
            included: HashMap::new(),
            bytes_left: options.max_bytes,
            max_bytes: options.max_bytes,
            max_line: options.max_line,
        })
    }

    /// A file that the caller names, wherever it is.
    pub(super) fn named(&mut self, file: &Path, memory: &mut Budget) -> Result<Rc<Source>, Error> {
        let path = canonical(file)?;
        let id = self.load(path, file.to_path_buf(), memory);
        id.map(|id| Rc::clone(&self.sources[id]))
            .map_err(|fault| Error::File { file: file.to_path_buf(), fault })
    }

    /// The file that another one calls `name`. To look for it on disk counts as work.
    pub(super) fn included(
        &mut self,
        (from, name): (&Source, &str),
        work: &mut Budget,
        memory: &mut Budget,
    ) -> Result<Rc<Source>, Cause> {
        let key = (from.id, name.to_string());
        if let Some(&id) = self.included.get(&key) {
            return Ok(Rc::clone(&self.sources[id]));
        }
        work.take(SEARCH_COST)?;
        let path = self.find(from, name)?;
        let file = from.shown.parent().unwrap_or(Path::new("")).join(name);
        memory.take((name.len() + ENTRY) as u64)?;
        let id = self.load(path, file, memory);
        let id = id.map_err(|fault| Cause::Include { name: shown(name), fault })?;
        self.included.insert(key, id);
        Ok(Rc::clone(&self.sources[id]))
    }

    /// Returns the path of an included file: by its name as it stands, or all in lower or all in
    /// upper case.
    fn find(&self, from: &Source, name: &str) -> Result<PathBuf, Cause> {
        if name.starts_with('/') || Path::new(name).is_absolute() {
            return Err(Cause::Absolute(shown(name)));
        }
        let folder = from.path.parent().unwrap_or(Path::new(""));
        let mut fault = FileFault::Read(ErrorKind::NotFound.into());
        for form in [name.to_string(), name.to_lowercase(), name.to_uppercase()] {
            // Nothing outside is touched, not even to see whether it exists.
            let path = self.confined(joined(folder, &form), name)?;
            match path.canonicalize() {
                Ok(path) => return self.confined(path, name),
                Err(error) if error.kind() == ErrorKind::NotFound => {}
                Err(error) => fault = error.into(),
            }
        }
        Err(Cause::Include { name: shown(name), fault })
    }

    fn confined(&self, path: PathBuf, name: &str) -> Result<PathBuf, Cause> {
        if path.starts_with(&self.root) {
            return Ok(path);
        }
        Err(Cause::Outside { name: shown(name), root: self.root.clone() })
    }

    fn load(
        &mut self,
        path: PathBuf,
        shown: PathBuf,
        memory: &mut Budget,
    ) -> Result<usize, FileFault> {
        if let Some(&id) = self.by_path.get(&path) {
            return Ok(id);
        }
        let bytes = self.read(&path)?;
        let id = self.sources.len();
        let (left, limit) = memory.left();
        let names = (shown.as_os_str().len() + 2 * path.as_os_str().len() + 2 * ENTRY) as u64;
        if Source::memory(&bytes) + names > left {
            return Err(FileFault::TooMuchMemory(limit));
        }
        let source = Source::new(id, shown, path.clone(), &bytes, self.max_line)?;
        // It has less than was asked for above.
        memory.take(source.kept() + names).map_err(|_| FileFault::TooMuchMemory(limit))?;
        self.sources.push(Rc::new(source));
        self.by_path.insert(path, id);
        Ok(id)
    }

    /// Reads no more than is left, whatever length the system states.
    fn read(&mut self, path: &Path) -> Result<Vec<u8>, FileFault> {
        // Opening a pipe would wait for its other end.
        if !fs::metadata(path)?.is_file() {
            return Err(FileFault::NotAFile);
        }
        let mut bytes = Vec::new();
        fs::File::open(path)?.take(self.bytes_left.saturating_add(1)).read_to_end(&mut bytes)?;
        match self.bytes_left.checked_sub(bytes.len() as u64) {
            Some(left) => self.bytes_left = left,
            None => return Err(FileFault::TooManyBytes(self.max_bytes)),
        }
        Ok(bytes)
    }
}

fn canonical(file: &Path) -> Result<PathBuf, Error> {
    let fault = |error| Error::File { file: file.to_path_buf(), fault: FileFault::Read(error) };
    file.canonicalize().map_err(fault)
}
