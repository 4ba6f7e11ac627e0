//! Finds what the parser was reading when it stopped.
//!
//! The text before that place is sound as far as the parser is concerned, so that
//! brackets, names and colons before it can be told apart without judging them.

use crate::locate::{Scanner, skip_blanks};
use std::ops::Range;

/// A bracket that is open at a place, and what is read inside.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Frame {
    /// The offset of the bracket.
    pub(crate) open: usize,
    /// The word before it, as `Phong`.
    pub(crate) name: Option<Range<usize>>,
    /// The field, or the key in quotes, whose value is read.
    pub(crate) field: Option<Range<usize>>,
    /// The offset at which this value, or that of a list, begins.
    value: usize,
}

/// The state of reading at a place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Reading {
    /// All brackets that are open, the innermost last.
    pub(crate) frames: Vec<Frame>,
    /// The last word, text in quotes, or sign.
    pub(crate) last: Range<usize>,
}

/// Reads up to a place.
pub(crate) fn read_to(text: &str, place: usize) -> Reading {
    let text = &text[..place.min(text.len())];
    let mut scanner = Scanner::new(text);
    let Reading { mut frames, mut last } = Reading::default();
    let mut word = None;
    loop {
        scanner.blanks();
        let start = scanner.at();
        let Some(found) = scanner.peek() else { return Reading { frames, last } };
        match found {
            '(' | '[' | '{' => {
                scanner.any();
                let frame =
                    Frame { open: start, name: word.take(), value: scanner.at(), field: None };
                frames.push(frame);
            }
            ')' | ']' | '}' => {
                scanner.any();
                frames.pop();
                word = None;
            }
            ':' | ',' => {
                scanner.any();
                if let Some(frame) = frames.last_mut() {
                    frame.field = word.take().filter(|_| found == ':');
                    frame.value = scanner.at();
                }
            }
            _ => {
                scanner.value_without_group();
                if scanner.at() == start {
                    scanner.any();
                }
                word = Some(start..scanner.at());
            }
        }
        last = start..scanner.at();
    }
}

/// A field of a file and what it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Context<'a> {
    /// The field; of an entry of a map its name in quotes.
    pub(crate) field: &'a str,
    /// The owner of the field: the name before the bracket, or the field whose value that is;
    /// `None` at the top.
    /// `None` at the top.
    pub(crate) owner: Option<&'a str>,
    /// The whole value.
    pub(crate) value: Range<usize>,
    /// True if the place is inside of brackets within the value.
    pub(crate) is_within: bool,
}

/// The innermost field whose value is read at a place.
pub(crate) fn context<'a>(text: &'a str, frames: &[Frame]) -> Option<Context<'a>> {
    let depth = frames.iter().rposition(|frame| frame.field.is_some())?;
    let frame = &frames[depth];
    let outer = frames[..depth].iter().rev().find_map(|outer| outer.field.clone());
    let start = skip_blanks(text, frame.value);
    let mut scanner = Scanner::new(text);
    scanner.go_to(start);
    scanner.value();
    Some(Context {
        field: &text[frame.field.clone()?],
        owner: frame.name.clone().or(outer).map(|owner| &text[owner]),
        value: start..scanner.at(),
        is_within: depth + 1 < frames.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"( // (
        materials: { "a": Textured(base: Phong(diffuse: (1, 2 ), exponent: 3), diffuse: (scale: 6)) },
        objects: [(shape: Sphere(radius: 1), material: "a b"), (x"#;

    fn at(word: &str) -> (String, Option<String>, String, bool) {
        let reading = read_to(TEXT, TEXT.find(word).unwrap());
        let found = context(TEXT, &reading.frames).unwrap();
        let owner = found.owner.map(str::to_string);
        (found.field.to_string(), owner, TEXT[found.value].to_string(), found.is_within)
    }

    fn expect(word: &str, field: &str, owner: Option<&str>, value: &str, is_within: bool) {
        let expected = (field.to_string(), owner.map(str::to_string), value.to_string(), is_within);
        assert_eq!(at(word), expected, "{word}");
    }

    #[test]
    fn the_field_around_a_place_is_found() {
        expect("2 )", "diffuse", Some("Phong"), "(1, 2 )", true);
        expect("3)", "exponent", Some("Phong"), "3", false);
        expect("6)", "scale", Some("diffuse"), "6", false);
        expect("Textured", "\"a\"", Some("materials"), TEXT_OF_A, false);
        expect("\"a b\"", "material", Some("objects"), "\"a b\"", false);
        expect("(x", "objects", None, &TEXT[TEXT.find('[').unwrap()..], true);
    }

    const TEXT_OF_A: &str =
        "Textured(base: Phong(diffuse: (1, 2 ), exponent: 3), diffuse: (scale: 6))";

    #[test]
    fn brackets_that_are_open_are_told() {
        let reading = read_to(TEXT, TEXT.len());
        let open: Vec<&str> =
            reading.frames.iter().map(|frame| &TEXT[frame.open..=frame.open]).collect();
        assert_eq!((open, &TEXT[reading.last]), (vec!["(", "[", "("], "x"));
        assert_eq!(read_to("", 9), Reading::default());
        for end in (0..TEXT.len()).filter(|&end| TEXT.is_char_boundary(end)) {
            let _ = context(TEXT, &read_to(TEXT, end).frames);
        }
    }
}
