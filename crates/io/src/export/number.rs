//! Numbers, vectors and words of scene files.

use std::fmt::Write;
use traylib_math::{Rgb, Vec3};

/// A number in the fewest digits that read back as the same.
pub(super) fn number(value: f32) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Numbers in parentheses.
pub(super) fn tuple(values: &[f32]) -> String {
    let numbers: Vec<String> = values.iter().map(|&value| number(value)).collect();
    format!("({})", numbers.join(", "))
}

pub(super) fn vector(vector: Vec3) -> String {
    tuple(&vector.to_array())
}

pub(super) fn colour(colour: Rgb) -> String {
    tuple(&colour.to_array())
}

/// Text in quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => _ = write!(quoted, "\\{letter}"),
            _ if letter.is_control() => _ = write!(quoted, "\\u{{{:x}}}", letter as u32),
            _ => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back() {
        for value in [0.0, -0.0, 1.0, 0.1, 1e-30, 3.4e38, f32::MIN_POSITIVE, 16_777_217.0, -1.5e-5]
        {
            let text = number(value);
            assert_eq!(text.parse::<f32>().unwrap().to_bits(), value.to_bits(), "{text}");
            let document = format!("(exposure: {text})");
            let read = crate::ron_scene::decode(&document).unwrap().exposure.unwrap();
            assert_eq!(read.to_bits(), value.to_bits(), "{text}");
        }
    }

    #[test]
    fn text_is_put_in_quotes() {
        assert_eq!(quoted("a\"b\\c\n"), "\"a\\\"b\\\\c\\u{a}\"");
    }
}
