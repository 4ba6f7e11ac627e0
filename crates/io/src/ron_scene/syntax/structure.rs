//! Brackets, commas, colons and what stands in their places.

use super::{Finding, Stop, line_of};
use crate::locate::skip_blanks;
use crate::ron_scene::context::{Frame, read_to};
use crate::suggest::shown;
use ron::error::Error;

/// An error before the first bracket, or after the last.
pub(super) fn around(stop: &Stop<'_>, code: &Error) -> Finding {
    if matches!(code, Error::TrailingCharacters) {
        let title = "the scene is closed before the end of the file";
        return Finding::new(stop.span(), title, "nothing may follow here")
            .with_help("is there a `)` too many before?");
    }
    let is_empty = skip_blanks(stop.text, 0) == stop.text.len();
    let looks_like = match stop.next().filter(|_| !is_empty) {
        None => {
            return Finding::new(stop.span(), "the file has no scene", "a scene begins with `(`");
        }
        Some('{') => Some("JSON"),
        Some('<') => Some("XML"),
        Some(_) => None,
    };
    let finding = Finding::new(stop.span(), "a scene begins with `(`", "here is something else");
    match looks_like {
        Some(format) => finding.with_help(format!(
            "this looks like {format}; scenes are in RON, as `(camera: (…), objects: […])`"
        )),
        None => finding,
    }
}

/// An error inside of brackets.
#[expect(
    clippy::wildcard_enum_match_arm,
    reason = "the parser's open set; what is left is told by what stands there"
)]
pub(super) fn within(stop: &Stop<'_>, code: &Error) -> Finding {
    match code {
        Error::ExpectedStringEnd => {
            let start = stop.text[..stop.place].rfind('"').map_or(stop.span(), |at| at..at + 1);
            return Finding::new(start, "a text in quotes has no end", "it begins here");
        }
        Error::InvalidEscape(_) => {
            return Finding::new(stop.span(), "`\\` begins no special character here", "")
                .with_help("folders are written with `/`, and `\\` itself as `\\\\`");
        }
        Error::UnclosedLineComment => return unclosed(stop),
        Error::UnclosedBlockComment => {
            return Finding::new(stop.span(), "a comment has no end", "")
                .with_help("`/*` wants `*/`");
        }
        Error::ExceededRecursionLimit => {
            return Finding::new(stop.span(), "too many brackets in brackets", "here");
        }
        Error::ExpectedDifferentStructName { expected, found } => {
            let title = format!("`{}` is not known here", shown(found));
            return Finding::new(stop.span(), title, "here")
                .with_help(format!("leave the name out, or write `{expected}`"));
        }
        _ => {}
    }
    match stop.next() {
        None => unclosed(stop),
        Some('#') => Finding::new(stop.span(), "`#` begins no comment", "here")
            .with_help("comments begin with `//`"),
        Some('\'') => Finding::new(stop.span(), "`'` is no quotation mark", "here")
            .with_help("names are in double quotes, as `\"white\"`"),
        Some(found @ (';' | '=')) => instead(stop, found),
        Some(found) if found.is_control() => {
            let title = format!("U+{:04X} is no character of a scene", u32::from(found));
            Finding::new(stop.span(), title, "here")
        }
        Some(found @ (')' | ']' | '}')) => closing(stop, found),
        Some(_) if wants_field(code) => no_field(stop),
        Some(_) if matches!(code, Error::ExpectedMapColon) => {
            Finding::new(stop.reading.last.clone(), "`:` is missing", "after this")
        }
        Some(_) => Finding::new(stop.reading.last.clone(), "`,` is missing", "after this"),
    }
}

fn wants_field(code: &Error) -> bool {
    matches!(
        code,
        Error::ExpectedIdentifier | Error::InvalidIdentifier(_) | Error::SuggestRawIdentifier(_)
    )
}

/// The innermost bracket that is open at the end of the file.
fn unclosed(stop: &Stop<'_>) -> Finding {
    let reading = read_to(stop.text, stop.text.len());
    let Some(Frame { open, .. }) = reading.frames.last() else {
        return Finding::new(stop.span(), "the file ends too early", "here");
    };
    let open = *open..*open + 1;
    let title = format!("`{}` is not closed", &stop.text[open.clone()]);
    Finding::new(open, title, "the file ends before")
}

fn instead(stop: &Stop<'_>, found: char) -> Finding {
    let before = &stop.text[stop.reading.last.clone()];
    let (wanted, help) = match found {
        ';' => (',', "`,` stands between values".to_string()),
        _ => (':', format!("write `{}: …`", shown(before))),
    };
    let title = format!("`{found}` stands where `{wanted}` is wanted");
    Finding::new(stop.span(), title, "here").with_help(help)
}

fn closing(stop: &Stop<'_>, found: char) -> Finding {
    let innermost = stop.reading.frames.last();
    let opened = innermost.and_then(|frame| stop.text[frame.open..].chars().next());
    let partner = match found {
        ')' => '(',
        ']' => '[',
        _ => '{',
    };
    match innermost {
        Some(frame) if opened != Some(partner) => {
            let (line, opened) = (line_of(stop.text, frame.open), opened.unwrap_or('('));
            let title = format!("`{found}` closes no bracket");
            Finding::new(stop.span(), title, "one too many")
                .with_help(format!("open is the `{opened}` of line {line}"))
        }
        Some(Frame { field: Some(field), .. }) => {
            let title = format!("`{}` has no value", shown(&stop.text[field.clone()]));
            Finding::new(field.clone(), title, "")
        }
        _ => Finding::new(stop.span(), "something is missing", "before this"),
    }
}

/// Something else where the name of a field should be.
fn no_field(stop: &Stop<'_>) -> Finding {
    let finding =
        Finding::new(stop.span(), "a field is wanted here, as `name: value`", "this is none");
    let next = stop.next().unwrap_or_default();
    let number = stop.text[..stop.reading.last.start].trim_end();
    let whole = number.rsplit(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    let rest = &stop.text[stop.place..];
    let fraction = rest.find(|c: char| !c.is_ascii_digit()).map_or(rest, |end| &rest[..end]);
    if next.is_ascii_digit() && !whole.is_empty() {
        return finding.with_help(format!("fractions have a point: `{whole}.{fraction}`"));
    }
    match stop.reading.frames.last() {
        Some(frame) if matches!(next, '(' | '[' | '{') => {
            let (line, opened) =
                (line_of(stop.text, frame.open), &stop.text[frame.open..=frame.open]);
            finding
                .with_help(format!("is a bracket missing? The `{opened}` of line {line} is open"))
        }
        _ => finding,
    }
}
