//! Carries out entities one after the other.

mod flow;

use super::budget::{Budget, limit};
use super::build::Builder;
use super::contexts::Contexts;
use super::files::Files;
use super::frames::Frames;
use super::keyword::Keyword;
use super::palette::Palette;
use super::source::Source;
use super::{Cause, Counts, Document, Error, Options, Place, Surface, WarningKind, Warnings};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// Contexts, stacks, and what has been made so far.
pub(super) struct Reader<'a> {
    options: &'a Options,
    files: Files,
    /// Files being read, the innermost last.
    calls: Vec<Call>,
    /// The line being read.
    line: u32,
    contexts: Contexts,
    frames: Frames,
    palette: Palette,
    surfaces: Vec<Surface>,
    text: Budget,
    polygon_vertices: Budget,
    counts: Counts,
    warnings: Warnings,
}

/// A file being read.
struct Call {
    source: Rc<Source>,
    /// The next line.
    next: usize,
    /// Transforms open around it, its own arguments included.
    frames: usize,
    /// Whether the innermost of these are its arguments.
    transformed: bool,
    /// Objects that it has opened.
    objects: u64,
}

/// Work beside reading, in bytes of text.
const SPECTRUM_COST: u64 = 2000;

impl<'a> Reader<'a> {
    pub(super) fn new(options: &'a Options, files: &[PathBuf]) -> Result<Self, Error> {
        Ok(Self {
            options,
            files: Files::new(options, files)?,
            calls: Vec::new(),
            line: 0,
            contexts: Contexts::new(),
            frames: Frames::new(options),
            palette: Palette::default(),
            surfaces: Vec::new(),
            text: Budget::new("bytes of text", options.max_text, "max_text"),
            polygon_vertices: Budget::new("vertices", options.max_vertices, "max_vertices"),
            counts: Counts::default(),
            warnings: Warnings::default(),
        })
    }

    /// Reads a file and whatever it includes.
    pub(super) fn read(&mut self, file: &Path) -> Result<(), Error> {
        let source = self.files.named(file)?;
        self.enter(source, false);
        while let Some(call) = self.calls.last_mut() {
            let source = Rc::clone(&call.source);
            let Some((number, text)) = source.line(call.next) else {
                self.end_of_file().map_err(|cause| self.error(Keyword::Include, cause))?;
                continue;
            };
            call.next += 1;
            self.line = number;
            self.line(text)?;
        }
        Ok(())
    }

    pub(super) fn finish(self) -> Document {
        let Self { surfaces, palette, warnings, mut counts, .. } = self;
        counts.material_definitions = self.contexts.materials.definitions;
        counts.color_definitions = self.contexts.colours.definitions;
        counts.vertex_definitions = self.contexts.vertices.definitions;
        let materials = palette.materials;
        let document = Document { surfaces, materials, warnings, counts: Counts::default() };
        counts.add_surfaces(&document);
        Document { counts, ..document }
    }

    fn enter(&mut self, source: Rc<Source>, transformed: bool) {
        let frames = self.frames.depth();
        self.calls.push(Call { source, next: 0, frames, transformed, objects: 0 });
    }

    fn line(&mut self, text: &str) -> Result<(), Error> {
        let mut words = text.split_ascii_whitespace();
        let first = words.next().unwrap_or("#");
        let entity = Keyword::of(first);
        let keyword = entity.unwrap_or(Keyword::Comment);
        let taken = self.text.take(text.len() as u64);
        taken.map_err(|cause| self.error(keyword, cause))?;
        match entity {
            None => self.unknown(first),
            Some(Keyword::Comment) => {}
            Some(keyword) => {
                self.count(keyword);
                let words: Vec<&str> = words.collect();
                self.entity(keyword, &words).map_err(|cause| self.error(keyword, cause))?;
            }
        }
        Ok(())
    }

    fn unknown(&mut self, word: &str) {
        let glued = word.starts_with('#');
        let kind =
            if glued { WarningKind::CommentWithoutBlank } else { WarningKind::UnknownEntity };
        self.counts.unknown_entities += 1;
        self.warn(kind, word);
    }

    fn count(&mut self, keyword: Keyword) {
        if keyword != Keyword::Object {
            *self.counts.entities_after_include_and_array.entry(keyword.name()).or_default() += 1;
        }
    }

    fn entity(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        match keyword {
            Keyword::Comment => Ok(()),
            Keyword::Object => self.object(words),
            Keyword::Transform => self.transform(words),
            Keyword::Include => self.include(words),
            Keyword::Luminaire => self.luminaire(words),
            Keyword::Face | Keyword::FaceWithHoles | Keyword::Prism => {
                self.polygon_vertices.take(words.len() as u64)?;
                self.surface(keyword, words)
            }
            Keyword::Sphere
            | Keyword::Cylinder
            | Keyword::Cone
            | Keyword::Ring
            | Keyword::Torus => self.surface(keyword, words),
            Keyword::Spectrum | Keyword::Temperature => {
                self.text.take(SPECTRUM_COST)?;
                self.contexts.set(keyword, words)
            }
            _ => self.contexts.set(keyword, words),
        }
    }

    fn surface(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        let (made, most) = (self.surfaces.len() as u64 + 1, self.options.max_surfaces);
        limit("surfaces", made, most, "max_surfaces")?;
        let transform = self.frames.total();
        let max_corners = self.options.max_corners;
        let builder = Builder { vertices: &self.contexts.vertices, transform, max_corners };
        match builder.build(keyword, words)? {
            None => self.warn(WarningKind::NoArea, keyword.name()),
            Some(shape) if !shape.is_finite() => self.warn(WarningKind::NotFinite, keyword.name()),
            Some(shape) => {
                let material = self.material();
                self.surfaces.push(Surface { shape, material });
            }
        }
        Ok(())
    }

    fn material(&mut self) -> usize {
        let (index, repairs) = self.palette.index(self.contexts.materials.current());
        let told = [
            (repairs.scaled_down, WarningKind::ScattersTooMuch),
            (repairs.without_luminance, WarningKind::ColourWithoutLuminance),
        ];
        for (_, kind) in told.into_iter().filter(|(met, _)| *met) {
            let name = Arc::clone(&self.palette.materials[index].name);
            self.warn(kind, &name);
        }
        index
    }

    fn luminaire(&mut self, words: &[&str]) -> Result<(), Cause> {
        let Some(file) = words.first() else {
            return Err(Cause::Arguments { expected: "a file and a transform", found: 0 });
        };
        self.warn(WarningKind::LuminaireSkipped, file);
        Ok(())
    }

    fn warn(&mut self, kind: WarningKind, subject: &str) {
        self.warnings.add(kind, subject, || place(&self.calls, self.line));
    }

    fn error(&self, keyword: Keyword, cause: Cause) -> Error {
        let place = place(&self.calls, self.line);
        Error::Entity { place, entity: keyword.name(), cause }
    }
}

/// The line being read.
fn place(calls: &[Call], line: u32) -> Place {
    let file = calls.last().map(|call| call.source.shown.clone()).unwrap_or_default();
    Place { file, line }
}
