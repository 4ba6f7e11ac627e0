//! Values of another kind than their field wants.

use super::{Finding, Stop};
use crate::locate::Scanner;
use crate::ron_scene::context::Context;
use crate::ron_scene::wanted::wanted;
use crate::srgb;
use crate::suggest::shown;
use ron::error::Error;
use std::ops::Range;

/// Tells whether an error is about the kind of a value, and not about brackets and commas.
#[expect(clippy::wildcard_enum_match_arm, reason = "the parser's open set")]
pub(super) fn is_about(stop: &Stop<'_>, code: &Error) -> bool {
    let begins_here = || stop.context().is_some_and(|context| context.value.start == stop.place);
    match code {
        Error::ExpectedArray
        | Error::ExpectedMap
        | Error::ExpectedBoolean
        | Error::ExpectedChar
        | Error::ExpectedFloat
        | Error::ExpectedInteger
        | Error::ExpectedString
        | Error::ExpectedStructLike
        | Error::ExpectedNamedStructLike(_)
        | Error::ExpectedUnit
        | Error::FloatUnderscore
        | Error::IntegerOutOfBounds
        | Error::InvalidIntegerDigit { .. }
        | Error::InvalidValueForType { .. }
        | Error::Message(_)
        | Error::UnderscoreAtBeginning => true,
        Error::ExpectedComma | Error::ExpectedStructLikeEnd => stop.is_at_fraction(),
        Error::ExpectedIdentifier
        | Error::InvalidIdentifier(_)
        | Error::SuggestRawIdentifier(_)
        | Error::ExpectedDifferentStructName { .. } => begins_here(),
        _ => false,
    }
}

/// Too many or too few numbers.
pub(super) fn count(stop: &Stop<'_>) -> Finding {
    let Some(context) = stop.context() else {
        return Finding::new(stop.span(), "too many or too few numbers", "");
    };
    let inside = stop.text[context.value.clone()].trim_matches(['(', ')', '[', ']']);
    let found = inside.split(',').filter(|value| !value.trim().is_empty()).count();
    let label = if found == 1 { "this is one".into() } else { format!("these are {found}") };
    Finding::new(context.value.clone(), title(&context, "another number of values"), label)
}

/// Something else.
pub(super) fn other(stop: &Stop<'_>, code: &Error) -> Finding {
    let Some(context) = stop.context() else {
        return Finding::new(stop.span(), format!("expected {}", plain(code)), "here");
    };
    let span = if context.is_within { token(stop) } else { context.value.clone() };
    let found = &stop.text[span.clone()];
    let finding = Finding::new(span, title(&context, plain(code)), label(code, found));
    match help(&context, found) {
        Some(help) => finding.with_help(help),
        None => finding,
    }
}

fn title(context: &Context<'_>, plain: &str) -> String {
    let wanted = wanted(context).unwrap_or(plain);
    match context.field.strip_prefix('"') {
        Some(name) => format!("`{}` wants {wanted}", shown(name.trim_end_matches('"'))),
        None => format!("`{}` wants {wanted}", shown(context.field)),
    }
}

/// The word, text or bracket where the parser stopped.
fn token(stop: &Stop<'_>) -> Range<usize> {
    if stop.is_at_fraction() {
        let Range { start, .. } = stop.reading.last;
        let mut scanner = Scanner::new(stop.text);
        scanner.go_to(start);
        scanner.value();
        return start..scanner.at();
    }
    let mut scanner = Scanner::new(stop.text);
    scanner.go_to(stop.place);
    scanner.value();
    // The parser may have read a sign already.
    let start = stop.place - usize::from(stop.text[..stop.place].ends_with(['-', '+']));
    if scanner.at() > start { start..scanner.at() } else { stop.span() }
}

/// Names the value that is wanted, where nothing better is known.
#[expect(clippy::wildcard_enum_match_arm, reason = "the parser's open set")]
fn plain(code: &Error) -> &'static str {
    match code {
        Error::ExpectedFloat | Error::FloatUnderscore => "a number",
        Error::ExpectedInteger
        | Error::IntegerOutOfBounds
        | Error::InvalidIntegerDigit { .. }
        | Error::ExpectedComma
        | Error::ExpectedStructLikeEnd => "a whole number",
        Error::ExpectedString => "a name or path in quotes",
        Error::ExpectedArray => "a list in `[…]`",
        Error::ExpectedMap => "names with values in `{…}`",
        Error::ExpectedStructLike | Error::ExpectedNamedStructLike(_) => "values in `(…)`",
        _ => "something else",
    }
}

fn label(code: &Error, found: &str) -> &'static str {
    let first = found.chars().next();
    match (code, first) {
        (Error::IntegerOutOfBounds, Some('-')) => "it is negative",
        (Error::IntegerOutOfBounds, _) => "it is too large",
        (Error::ExpectedComma | Error::ExpectedStructLikeEnd, _) => "this is no whole number",
        (_, Some('"')) => "this is a text",
        (_, Some('[')) => "this is a list",
        (_, Some('(')) => "these are several values",
        (_, Some('{')) => "these are names with values",
        (_, Some('0'..='9' | '-' | '+' | '.')) => "this is one number",
        (_, Some(c)) if c.is_alphabetic() => "this is a word",
        _ => "here",
    }
}

fn help(context: &Context<'_>, found: &str) -> Option<String> {
    let is_short = found.len() <= 60 && !found.contains('\n');
    let is_name = matches!(context.field, "material" | "file");
    if is_name && found.contains('(') {
        let help = "give it a name in `materials: { \"name\": … }`, and write the name here";
        return Some(help.to_string());
    }
    let is_word =
        is_short && found.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.'));
    let wants_quotes = is_name || (context.field == "materials" && context.is_within);
    if wants_quotes && is_word && found.starts_with(char::is_alphabetic) {
        return Some(format!("write `\"{found}\"`"));
    }
    if is_short && found.starts_with('[') && found.ends_with(']') {
        return Some(format!("write `({})`", &found[1..found.len() - 1]));
    }
    hex_colour(found)
}

/// Explains a colour of the web as a linear colour.
fn hex_colour(found: &str) -> Option<String> {
    let digits = found.strip_prefix("\"#")?.strip_suffix('"')?;
    let code = u32::from_str_radix(digits, 16).ok().filter(|_| digits.len() == 6)?;
    let [_, bytes @ ..] = code.to_be_bytes();
    let [r, g, b] = bytes.map(|byte| srgb::decode(f32::from(byte) / 255.0));
    Some(format!("colours are linear: this one is `({r:.3}, {g:.3}, {b:.3})`"))
}
