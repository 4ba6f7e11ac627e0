//! Finds the place of a value in the text of a scene file.
//!
//! The parser keeps no positions, so errors found after parsing come back here
//! with the path of the value. The text has been parsed before: this scanner
//! only has to find its way, not to judge.

use std::fmt;
use std::ops::Range;

/// One step from a value to one inside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A field of a struct.
    Field(&'static str),
    /// An element of a list, from 0.
    Index(usize),
    /// The key of the n-th entry of a map, from 0.
    Key(usize),
    /// The value of the n-th entry of a map, from 0.
    Value(usize),
}

/// A path from the whole file to a value, shown as `objects[3].material`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Path(Vec<Step>);

impl Path {
    /// The path of a field of the file.
    pub fn of(field: &'static str) -> Self {
        Self(vec![Step::Field(field)])
    }

    /// This path and one step more.
    #[must_use]
    pub fn then(&self, step: Step) -> Self {
        Self(self.0.iter().copied().chain([step]).collect())
    }

    /// The path of the value that this one is in; `None` of a field of the file.
    pub fn parent(&self) -> Option<Self> {
        let (_, before) = self.0.split_last()?;
        (!before.is_empty()).then(|| Self(before.to_vec()))
    }

    /// This path and a field more.
    #[must_use]
    pub fn field(&self, name: &'static str) -> Self {
        self.then(Step::Field(name))
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, step) in self.0.iter().enumerate() {
            match step {
                Step::Field(name) if place == 0 => write!(f, "{name}")?,
                Step::Field(name) => write!(f, ".{name}")?,
                Step::Index(n) | Step::Key(n) | Step::Value(n) => write!(f, "[{n}]")?,
            }
        }
        Ok(())
    }
}

/// The bytes of the value at the end of a path; `None` if there is none.
pub fn locate(text: &str, path: &Path) -> Option<Range<usize>> {
    let mut scanner = Scanner { text, at: 0 };
    scanner.attributes();
    for &step in &path.0 {
        scanner.enter(step)?;
    }
    scanner.blanks();
    let start = scanner.at;
    scanner.value();
    (scanner.at > start).then_some(start..scanner.at)
}

/// [`locate`], or the bytes of the nearest value around, if a default was meant.
pub(crate) fn locate_near(text: &str, path: &Path) -> Option<Range<usize>> {
    let mut path = Some(path.clone());
    while let Some(tried) = path {
        if let Some(found) = locate(text, &tried) {
            return Some(found);
        }
        path = tried.parent();
    }
    None
}

/// The first byte at or after `at` that is neither blank nor in a comment.
pub(crate) fn skip_blanks(text: &str, at: usize) -> usize {
    let mut scanner = Scanner { text, at };
    scanner.blanks();
    scanner.at
}

/// Finds its way in a text.
pub(super) struct Scanner<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Scanner<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn go_to(&mut self, at: usize) {
        self.at = at;
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    pub(super) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Passes the next character if it is this one.
    fn pass(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn pass_while(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !wanted(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    pub(super) fn blanks(&mut self) {
        loop {
            self.pass_while(char::is_whitespace);
            if self.rest().starts_with("//") {
                self.pass_while(|c| c != '\n');
            } else if self.rest().starts_with("/*") {
                self.block_comment();
            } else {
                return;
            }
        }
    }

    /// Block comments nest.
    fn block_comment(&mut self) {
        let mut depth = 0_u32;
        while !self.rest().is_empty() {
            if self.rest().starts_with("/*") {
                depth += 1;
                self.at += 2;
            } else if self.rest().starts_with("*/") {
                depth -= 1;
                self.at += 2;
                if depth == 0 {
                    return;
                }
            } else {
                self.any();
            }
        }
    }

    pub(super) fn any(&mut self) {
        self.at += self.peek().map_or(0, char::len_utf8);
    }

    /// Passes `#![enable(…)]` lines at the beginning.
    fn attributes(&mut self) {
        self.blanks();
        while self.rest().starts_with("#!") {
            self.at += 2;
            self.group();
            self.blanks();
        }
    }

    fn word(&mut self) -> &'a str {
        self.pass_while(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '+' | '.'))
    }

    /// Passes a value: a string, a bracketed group, or a word that a group may
    /// follow.
    pub(super) fn value(&mut self) {
        self.blanks();
        match self.peek() {
            Some('"') => self.string(),
            Some('(' | '[' | '{') => self.group(),
            _ if self.at_raw_string() => self.raw_string(),
            _ => {
                self.word();
                let end = self.at;
                self.blanks();
                if self.peek() == Some('(') {
                    self.group();
                } else {
                    self.at = end;
                }
            }
        }
    }

    /// Passes a string or a word.
    pub(super) fn value_without_group(&mut self) {
        match self.peek() {
            Some('"') => self.string(),
            _ if self.at_raw_string() => self.raw_string(),
            _ => _ = self.word(),
        }
    }

    fn string(&mut self) {
        self.any();
        while let Some(c) = self.peek() {
            self.any();
            match c {
                '\\' => self.any(),
                '"' => return,
                _ => {}
            }
        }
    }

    fn at_raw_string(&self) -> bool {
        self.rest()
            .strip_prefix('r')
            .is_some_and(|rest| rest.trim_start_matches('#').starts_with('"'))
    }

    fn raw_string(&mut self) {
        self.any();
        let hashes = self.pass_while(|c| c == '#');
        self.any();
        let end = format!("\"{hashes}");
        self.at = self.rest().find(&end).map_or(self.text.len(), |i| self.at + i + end.len());
    }

    /// Passes everything up to the bracket that closes the one here.
    fn group(&mut self) {
        let mut depth = 0_u32;
        loop {
            self.blanks();
            match self.peek() {
                None => return,
                Some('(' | '[' | '{') => depth += 1,
                Some(')' | ']' | '}') => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        self.any();
                        return;
                    }
                }
                Some('"') => {
                    self.string();
                    continue;
                }
                _ if self.at_raw_string() => {
                    self.raw_string();
                    continue;
                }
                _ => {}
            }
            self.any();
        }
    }

    /// Goes to the value that `step` leads to.
    fn enter(&mut self, step: Step) -> Option<()> {
        self.blanks();
        self.word();
        self.blanks();
        let opening = self.peek()?;
        matches!(opening, '(' | '[' | '{').then(|| self.any())?;
        for count in 0.. {
            self.blanks();
            if matches!(self.peek()?, ')' | ']' | '}') {
                return None;
            }
            if self.arrives(step, count)? {
                return Some(());
            }
            self.value();
            self.blanks();
            self.pass(',');
        }
        None
    }

    /// Tells whether the entry with this number is the one wanted. The scanner then
    /// stands before what was wanted, else before the entry's value.
    fn arrives(&mut self, step: Step, count: usize) -> Option<bool> {
        match step {
            Step::Index(wanted) => Some(count == wanted),
            Step::Field(wanted) => {
                let name = self.word();
                self.colon()?;
                Some(name == wanted)
            }
            Step::Key(wanted) if count == wanted => Some(true),
            Step::Key(wanted) | Step::Value(wanted) => {
                self.value();
                self.colon()?;
                Some(matches!(step, Step::Value(_)) && count == wanted)
            }
        }
    }

    fn colon(&mut self) -> Option<()> {
        self.blanks();
        self.pass(':').then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r##"
        #![enable(implicit_some)] // (
        (
            include: [r#"a ) " b"#, "c"],
            materials: { "white )": Lambert(reflectance: (1, /* [ /* ( */ */ 2, 3)), "red": Mirror() },
            objects: [
                (shape: Quad(corner: (0, -1e5, 1)), material: "white \" )"),
                // (shape: nothing)
                (shape: Unit, sides: Front, ),
            ],
            spp: 64
        )"##;

    fn found(path: &Path) -> Option<&'static str> {
        locate(TEXT, path).map(|range| &TEXT[range])
    }

    #[test]
    fn values_are_found_past_strings_and_comments() {
        let objects = Path::of("objects");
        let first = objects.then(Step::Index(0));
        let corner = first.field("shape").field("corner");
        assert_eq!(found(&corner.then(Step::Index(1))), Some("-1e5"));
        assert_eq!(found(&first.field("material")), Some(r#""white \" )""#));
        assert_eq!(found(&objects.then(Step::Index(1)).field("sides")), Some("Front"));
        assert_eq!(found(&Path::of("spp")), Some("64"));
        assert_eq!(found(&Path::of("include").then(Step::Index(0))), Some(r##"r#"a ) " b"#"##));
        assert_eq!(found(&Path::of("include").then(Step::Index(1))), Some("\"c\""));
    }

    #[test]
    fn map_entries_are_found_by_number() {
        let materials = Path::of("materials");
        assert_eq!(found(&materials.then(Step::Key(0))), Some("\"white )\""));
        assert_eq!(found(&materials.then(Step::Key(1))), Some("\"red\""));
        assert_eq!(found(&materials.then(Step::Value(1))), Some("Mirror()"));
        let third = materials.then(Step::Value(0)).field("reflectance").then(Step::Index(2));
        assert_eq!(found(&third), Some("3"));
    }

    #[test]
    fn what_is_not_there_is_not_found() {
        let objects = Path::of("objects");
        for path in [Path::of("camera"), objects.then(Step::Index(2)), objects.field("x")] {
            assert_eq!(found(&path), None, "{path}");
        }
    }

    #[test]
    fn damaged_text_ends_the_search() {
        let path = Path::of("objects").then(Step::Index(1)).field("sides");
        for end in (0..TEXT.len()).filter(|&end| TEXT.is_char_boundary(end)) {
            let _ = locate(&TEXT[..end], &path);
        }
    }

    #[test]
    fn paths_read_like_code() {
        let path = Path::of("objects").then(Step::Index(3)).field("material");
        assert_eq!(path.to_string(), "objects[3].material");
    }
}
