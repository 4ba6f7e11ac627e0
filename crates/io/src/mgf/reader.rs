//! Carries out entities one after the other.

mod flow;

use super::budget::{Budget, limit};
use super::build::Builder;
use super::contexts::Contexts;
use super::files::Files;
use super::frames::Frames;
use super::keyword::Keyword;
use super::material_table::MaterialTable;
use super::source::Source;
use super::{
    Cause, Counts, Document, Error, Options, Place, Shape, Surface, Vertex, WarningKind, Warnings,
};
use crate::Limit;
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
    material_table: MaterialTable,
    surfaces: Vec<Surface>,
    work: Budget,
    memory: Budget,
    cutting: Budget,
    /// The number of times that each entity was met, by the number of its keyword.
    entities: [u64; Keyword::COUNT],
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
    /// True if the innermost of these are its arguments.
    transformed: bool,
    /// Objects that it has opened.
    objects: u64,
}

/// Work beside reading, in bytes of text.
const LINE_COST: u64 = 16;
const WORD_COST: u64 = 8;
const SPECTRUM_COST: u64 = 1024;
const BLACK_BODY_COST: u64 = 4096;
const SURFACE_COST: u64 = 16;
/// A corner of a polygon or a part of a mixture, to be looked up.
const NAME_COST: u64 = 8;
/// A number with more digits than are looked at.
const LONG_WORD: usize = 19;
const LONG_WORD_COST: u64 = 128;
const MATERIAL_COST: u64 = 64;
const WARNING_COST: u64 = 128;

/// Memory of a vector of vertices beside these.
const LOOP: usize = 48;

impl<'a> Reader<'a> {
    pub(super) fn new(options: &'a Options, files: &[PathBuf]) -> Result<Self, Error> {
        Ok(Self {
            options,
            files: Files::new(options, files)?,
            calls: Vec::new(),
            line: 0,
            contexts: Contexts::new(),
            frames: Frames::new(options),
            material_table: MaterialTable::default(),
            surfaces: Vec::new(),
            work: Budget::new("bytes of text and other work", options.max_work, Limit::Work),
            memory: Budget::new("bytes of memory", options.max_memory, Limit::Memory),
            cutting: Budget::new("squares of vertices", options.max_cutting, Limit::Cutting),
            entities: [0; Keyword::COUNT],
            counts: Counts::default(),
            warnings: Warnings::default(),
        })
    }

    /// Reads a file and whatever it includes.
    pub(super) fn read(&mut self, file: &Path) -> Result<(), Error> {
        let source = self.files.named(file, &mut self.memory)?;
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
        let Self { surfaces, material_table, warnings, mut counts, .. } = self;
        for keyword in Keyword::all().filter(|&keyword| self.entities[keyword as usize] > 0) {
            let count = self.entities[keyword as usize];
            counts.entities_after_include_and_array.insert(keyword.name(), count);
        }
        counts.material_definitions = self.contexts.materials.definitions;
        counts.color_definitions = self.contexts.colours.definitions;
        counts.vertex_definitions = self.contexts.vertices.definitions;
        let materials = material_table.materials;
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
        let words = if entity.is_some() && keyword != Keyword::Comment {
            words.collect()
        } else {
            Vec::new()
        };
        let done = self.work.take(cost(text, &words)).and_then(|()| match entity {
            None => self.unknown(first),
            Some(Keyword::Comment) => Ok(()),
            Some(keyword) => {
                self.count(keyword);
                self.entity(keyword, &words)
            }
        });
        done.map_err(|cause| self.error(keyword, cause))
    }

    fn unknown(&mut self, word: &str) -> Result<(), Cause> {
        self.work.take(WARNING_COST)?;
        let glued = word.starts_with('#');
        let kind =
            if glued { WarningKind::CommentWithoutBlank } else { WarningKind::UnknownEntity };
        self.counts.unknown_entities += 1;
        self.warn(kind, word);
        Ok(())
    }

    fn count(&mut self, keyword: Keyword) {
        if keyword != Keyword::Object {
            self.entities[keyword as usize] += 1;
        }
    }

    fn entity(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        match keyword {
            Keyword::Comment => Ok(()),
            Keyword::Object => self.object(words),
            Keyword::Transform => self.transform(words),
            Keyword::Include => self.include(words),
            Keyword::Luminaire => self.luminaire(words),
            Keyword::Face
            | Keyword::FaceWithHoles
            | Keyword::Prism
            | Keyword::Sphere
            | Keyword::Cylinder
            | Keyword::Cone
            | Keyword::Ring
            | Keyword::Torus => self.surface(keyword, words),
            Keyword::Colour
            | Keyword::Chromaticity
            | Keyword::Spectrum
            | Keyword::Temperature
            | Keyword::Mix
            | Keyword::Material
            | Keyword::Sides
            | Keyword::DiffuseReflectance
            | Keyword::DiffuseTransmittance
            | Keyword::SpecularReflectance
            | Keyword::SpecularTransmittance
            | Keyword::Emittance
            | Keyword::Refraction
            | Keyword::Vertex
            | Keyword::Point
            | Keyword::Normal => self.context(keyword, words),
        }
    }

    #[expect(clippy::wildcard_enum_match_arm, reason = "the others take no time to speak of")]
    fn context(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        match keyword {
            Keyword::Spectrum => self.work.take(SPECTRUM_COST)?,
            Keyword::Temperature => self.work.take(BLACK_BODY_COST)?,
            Keyword::Mix => self.work.take(words.len() as u64 * NAME_COST)?,
            _ => {}
        }
        let kept = self.contexts.kept();
        self.contexts.set(keyword, words)?;
        self.memory.take(self.contexts.kept() - kept)
    }

    fn surface(&mut self, keyword: Keyword, words: &[&str]) -> Result<(), Cause> {
        let (made, most) = (self.surfaces.len() as u64 + 1, self.options.max_surfaces);
        limit("surfaces", made, most, Limit::Surfaces)?;
        self.work.take(SURFACE_COST + words.len() as u64 * NAME_COST)?;
        let transform = self.frames.total();
        let max_corners = self.options.max_corners;
        let builder = Builder { vertices: &self.contexts.vertices, transform, max_corners };
        let fault = match builder.build(keyword, words)? {
            None => WarningKind::NoArea,
            Some(shape) if !shape.is_finite() => WarningKind::NotFinite,
            Some(shape) => return self.keep(shape),
        };
        self.work.take(WARNING_COST)?;
        self.warn(fault, keyword.name());
        Ok(())
    }

    fn keep(&mut self, shape: Shape) -> Result<(), Cause> {
        self.cutting.take(shape.cutting())?;
        let (loops, vertices) = shape.kept();
        let memory = size_of::<Surface>() + loops * LOOP + vertices * size_of::<Vertex>();
        self.memory.take(memory as u64)?;
        let material = self.material()?;
        self.surfaces.push(Surface { shape, material });
        Ok(())
    }

    fn material(&mut self) -> Result<usize, Cause> {
        let known = self.material_table.materials.len();
        let (index, repairs) = self.material_table.index(self.contexts.materials.current());
        if index < known {
            return Ok(index);
        }
        self.work.take(MATERIAL_COST)?;
        self.memory.take(MaterialTable::MEMORY)?;
        let told = [
            (repairs.scaled_down, WarningKind::ScattersTooMuch),
            (repairs.without_luminance, WarningKind::ColourWithoutLuminance),
        ];
        for (_, kind) in told.into_iter().filter(|(met, _)| *met) {
            let name = Arc::clone(&self.material_table.materials[index].name);
            self.warn(kind, &name);
        }
        Ok(index)
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

/// Returns the cost of reading a line, in bytes of text. Comments are not read.
fn cost(text: &str, words: &[&str]) -> u64 {
    let text = if words.is_empty() { 0 } else { text.len() as u64 };
    let long = words.iter().filter(|word| word.len() > LONG_WORD).count() as u64;
    LINE_COST + text + words.len() as u64 * WORD_COST + long * LONG_WORD_COST
}

/// The line being read.
fn place(calls: &[Call], line: u32) -> Place {
    let file = calls.last().map(|call| call.source.shown.clone()).unwrap_or_default();
    Place { file, line }
}
