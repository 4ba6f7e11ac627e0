//! What the parser says about a text, in the words of a scene file.

use crate::report::{Problem, SourceText};
use crate::ron_scene::locate::skip_blanks;
use crate::suggest::{nearest, quoted_list};
use ron::error::{Error, Position, SpannedError};
use std::ops::Range;
use std::sync::Arc;

/// The parser's error with its place and advice.
pub(crate) fn problem(source: &Arc<SourceText>, error: &SpannedError) -> Problem {
    let (title, label, help) = explain(&error.code);
    let span = Some(span(&source.text, error));
    Problem { source: Arc::clone(source), span, title, label, help }
}

/// Title, label and help.
#[expect(clippy::wildcard_enum_match_arm, reason = "the reader's own words will do")]
fn explain(error: &Error) -> (String, String, Option<String>) {
    match error {
        Error::NoSuchStructField { expected, found, outer } => {
            let title = format!("unknown field `{found}`{}", inside(outer.as_deref()));
            unknown(title, found, expected)
        }
        Error::NoSuchEnumVariant { expected, found, outer } => {
            let kind = outer.as_deref().unwrap_or("kind").to_lowercase();
            unknown(format!("unknown {kind} `{found}`"), found, expected)
        }
        Error::MissingStructField { field, outer } => {
            let title = format!("missing field `{field}`{}", inside(outer.as_deref()));
            (title, format!("`{field}` is needed before here"), None)
        }
        Error::DuplicateStructField { field, outer } => {
            let title = format!("field `{field}` is given twice{}", inside(outer.as_deref()));
            (title, "second time".to_string(), None)
        }
        Error::ExpectedFloat => expected("expected a number"),
        Error::ExpectedInteger => expected("expected a whole number"),
        Error::ExpectedString => expected("expected a name or path in quotes"),
        Error::Eof => expected("the file ends too early"),
        other => expected(&lower_first(&other.to_string())),
    }
}

fn expected(title: &str) -> (String, String, Option<String>) {
    (title.to_string(), "here".to_string(), None)
}

fn unknown(title: String, found: &str, expected: &[&str]) -> (String, String, Option<String>) {
    let label = nearest(found, expected.iter().copied())
        .map_or_else(|| "not known".to_string(), |near| format!("did you mean `{near}`?"));
    let help = format!("expected one of {}", quoted_list(expected.iter().copied()));
    (title, label, Some(help))
}

fn inside(outer: Option<&str>) -> String {
    outer.map_or_else(String::new, |outer| format!(" in `{outer}`"))
}

fn lower_first(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_lowercase().chain(chars).collect())
}

/// The bytes that an error is about.
#[expect(clippy::wildcard_enum_match_arm, reason = "the others name nothing")]
fn span(text: &str, error: &SpannedError) -> Range<usize> {
    let name = match &error.code {
        Error::NoSuchStructField { found, .. } | Error::NoSuchEnumVariant { found, .. } => {
            Some(found.as_str())
        }
        Error::DuplicateStructField { field, .. } => Some(*field),
        _ => None,
    };
    let (start, end) = (offset(text, error.span.start), offset(text, error.span.end));
    if let Some(named) = name.and_then(|name| word_near(text, name, end)) {
        return named;
    }
    // The parser stops before the blanks in front of what it does not like.
    let start = skip_blanks(text, start);
    if start < text.len() { start..end.max(start) } else { last_character(text) }
}

/// The last place before or at `end` where a word stands: the parser's position
/// for a name is up to a word off.
fn word_near(text: &str, word: &str, end: usize) -> Option<Range<usize>> {
    let limit = text.ceil_char_boundary((end + word.len()).min(text.len()));
    let start = text[..limit].rfind(word)?;
    Some(start..start + word.len())
}

fn last_character(text: &str) -> Range<usize> {
    let end = text.trim_end().len();
    text.floor_char_boundary(end.saturating_sub(1))..end
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
