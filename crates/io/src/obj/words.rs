//! Words of a statement.

use super::Cause;

/// Splits a line into words, up to a comment.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    words.take_while(|word| !word.starts_with(b"#"))
}

/// Returns what follows the first word, as a name: it may have blanks and signs of any kind.
pub(super) fn name(line: &[u8]) -> String {
    let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
    String::from_utf8_lossy(line[end..].trim_ascii()).into_owned()
}

/// Shortens a word for a message.
pub(super) fn shown(word: &[u8]) -> String {
    crate::suggest::shown(&String::from_utf8_lossy(word))
}

/// Reads a number that may be infinite or none.
pub(super) fn any_number(word: &[u8]) -> Result<f32, Cause> {
    let value = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
    value.ok_or_else(|| Cause::NotANumber(shown(word)))
}

/// Reads a finite number.
pub(super) fn number(word: &[u8]) -> Result<f32, Cause> {
    let value = any_number(word)?;
    if value.is_finite() { Ok(value) } else { Err(Cause::NotFinite(shown(word))) }
}
