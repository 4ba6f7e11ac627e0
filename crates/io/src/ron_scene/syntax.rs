//! The errors of the parser, in the words of a scene file.

mod structure;
mod value;

use super::context::{Context, Reading, context, read_to};
use crate::locate::skip_blanks;
use crate::report::{Problem, SourceText, Spot};
use crate::suggest::{nearest, quoted_list, shown};
use ron::error::{Error, Position, SpannedError};
use std::ops::Range;
use std::sync::Arc;

/// A message, and its place.
struct Finding {
    span: Range<usize>,
    title: String,
    label: String,
    help: Option<String>,
}

impl Finding {
    fn new(span: Range<usize>, title: impl Into<String>, label: impl Into<String>) -> Self {
        Self { span, title: title.into(), label: label.into(), help: None }
    }

    fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

/// A text, and where the parser stopped.
struct Stop<'a> {
    text: &'a str,
    /// The first character that it did not like, past blanks.
    place: usize,
    reading: Reading,
}

impl<'a> Stop<'a> {
    fn context(&self) -> Option<Context<'a>> {
        context(self.text, &self.reading.frames)
    }

    fn next(&self) -> Option<char> {
        self.text[self.place..].chars().next()
    }

    /// Tells whether it stopped at the point of a number.
    fn is_at_fraction(&self) -> bool {
        self.next() == Some('.') && self.reading.last.end == self.place
    }

    /// Tells whether it stopped between values without names.
    fn is_in_tuple(&self) -> bool {
        let innermost = self.reading.frames.last();
        let is_plain = innermost.is_some_and(|frame| frame.name.is_none() && frame.field.is_none());
        is_plain
            && self.next().is_some_and(|c| !matches!(c, ')' | ']' | '}' | '#' | ';'))
            && self.context().is_some_and(|context| context.is_within)
    }

    /// The next character, or the last one of the text.
    fn span(&self) -> Range<usize> {
        let length = self.next().map_or(0, char::len_utf8);
        if length > 0 { self.place..self.place + length } else { last_character(self.text) }
    }
}

/// The parser's error with its place and advice.
pub(crate) fn problem(source: &Arc<SourceText>, error: &SpannedError) -> Problem {
    let text = &source.text;
    let place = skip_blanks(text, offset(text, error.span.start));
    let stop = Stop { text, place, reading: read_to(text, place) };
    let Finding { span, title, label, help } = explain(&stop, error);
    Problem { source: Arc::clone(source), spot: Spot::Bytes(span), title, label, help }
}

/// Tells whether a text begins as a scene file does.
pub(crate) fn is_begun(text: &str) -> bool {
    let rest = text[skip_blanks(text, 0)..].trim_start_matches(|c: char| c.is_alphanumeric());
    rest.starts_with('(') || rest.starts_with("#!")
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the parser's open set")]
fn explain(stop: &Stop<'_>, error: &SpannedError) -> Finding {
    match &error.code {
        Error::NoSuchStructField { expected, found, outer } => {
            let title = format!("unknown field `{}`{}", shown(found), inside(outer.as_deref()));
            unknown(named(stop, error, found), title, found, expected)
        }
        Error::NoSuchEnumVariant { expected, found, outer } => {
            let kind = outer.as_deref().unwrap_or("kind").to_lowercase();
            let title = format!("unknown {kind} `{}`", shown(found));
            unknown(named(stop, error, found), title, found, expected)
        }
        Error::MissingStructField { field, outer } => {
            let title = format!("missing field `{field}`{}", inside(outer.as_deref()));
            Finding::new(stop.span(), title, format!("`{field}` is needed before here"))
        }
        Error::DuplicateStructField { field, outer } => {
            let title = format!("field `{field}` is given twice{}", inside(outer.as_deref()));
            Finding::new(named(stop, error, field), title, "second time")
        }
        Error::ExpectedDifferentLength { .. } => value::count(stop),
        Error::ExpectedStructLikeEnd if !stop.is_at_fraction() && stop.is_in_tuple() => {
            value::count(stop)
        }
        code if stop.reading.frames.is_empty() => structure::around(stop, code),
        code if stop.next().is_none() => structure::within(stop, code),
        code if value::is_about(stop, code) => value::other(stop, code),
        code => structure::within(stop, code),
    }
}

fn unknown(span: Range<usize>, title: String, found: &str, expected: &[&str]) -> Finding {
    let label = nearest(found, expected.iter().copied())
        .map_or_else(|| "not known".to_string(), |near| format!("did you mean `{near}`?"));
    let help = format!("expected one of {}", quoted_list(expected.iter().copied()));
    Finding::new(span, title, label).with_help(help)
}

fn inside(outer: Option<&str>) -> String {
    outer.map_or_else(String::new, |outer| format!(" in `{outer}`"))
}

/// Returns the place of a name that the parser has just read: its position is up to a word off.
fn named(stop: &Stop<'_>, error: &SpannedError, word: &str) -> Range<usize> {
    let text = stop.text;
    let end = offset(text, error.span.end) + word.len();
    let limit = text.ceil_char_boundary(end.min(text.len()));
    text[..limit].rfind(word).map_or_else(|| stop.span(), |start| start..start + word.len())
}

fn last_character(text: &str) -> Range<usize> {
    let end = text.trim_end().len();
    text.floor_char_boundary(end.saturating_sub(1))..end
}

/// The line, from one, that a byte is in.
fn line_of(text: &str, at: usize) -> usize {
    text[..at].split('\n').count()
}

/// Byte offset of a position counted in lines and characters from one.
fn offset(text: &str, position: Position) -> usize {
    let before = |line: &str| line.len();
    let line_start: usize =
        text.split_inclusive('\n').take(position.line.saturating_sub(1)).map(before).sum();
    let rest = &text[line_start.min(text.len())..];
    let columns = rest.chars().take(position.col.saturating_sub(1)).map(char::len_utf8);
    line_start + columns.sum::<usize>()
}
