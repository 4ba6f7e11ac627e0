//! The text of a file, cut into lines.

use super::FileFault;
use std::path::PathBuf;

/// The byte order mark, which some editors put before text in UTF-8.
const MARK: &[u8] = "\u{feff}".as_bytes();

/// A file that was read.
#[derive(Debug)]
pub(super) struct Source {
    /// Position among the files read.
    pub(super) id: usize,
    /// Its name for messages.
    pub(super) shown: PathBuf,
    /// Its one name on disk.
    pub(super) path: PathBuf,
    text: String,
    lines: Vec<Line>,
}

/// A line that is not empty. It ends where the next one begins.
#[derive(Clone, Copy, Debug)]
struct Line {
    number: u32,
    start: u32,
}

impl Source {
    /// Takes a file apart. Bytes that are no text become replacement marks.
    pub(super) fn new(
        id: usize,
        shown: PathBuf,
        path: PathBuf,
        bytes: &[u8],
        max_line: usize,
    ) -> Result<Self, FileFault> {
        let (text, lines) = join(bytes.strip_prefix(MARK).unwrap_or(bytes), max_line)?;
        Ok(Self { id, shown, path, text, lines })
    }

    /// The most memory that it takes to take these bytes apart.
    pub(super) fn memory(bytes: &[u8]) -> u64 {
        // A byte that is no text becomes three.
        let longer = if std::str::from_utf8(bytes).is_ok() { 1 } else { 3 };
        let ends = bytes.iter().filter(|&&byte| is_end(byte)).count() as u64;
        (1 + longer) * bytes.len() as u64 + (ends + 1) * size_of::<Line>() as u64
    }

    /// Returns the memory that it keeps, in bytes.
    pub(super) fn kept(&self) -> u64 {
        (self.text.len() + size_of_val(&self.lines[..])) as u64
    }

    /// A joined line and its number in the file.
    pub(super) fn line(&self, index: usize) -> Option<(u32, &str)> {
        let line = self.lines.get(index)?;
        let end = self.lines.get(index + 1).map_or(self.text.len(), |next| next.start as usize);
        Some((line.number, &self.text[line.start as usize..end]))
    }
}

/// Text and lines with continuations joined by a blank. A line ends with LF, CR
/// or CR LF; a backslash before any of these joins the next one. Empty lines
/// are left out.
fn join(bytes: &[u8], max_line: usize) -> Result<(String, Vec<Line>), FileFault> {
    let mut joined = String::with_capacity(bytes.len());
    let mut lines = Vec::new();
    let mut line = Line { number: 1, start: 0 };
    for (number, text) in (1..).zip(physical_lines(bytes)) {
        let continued = text.strip_suffix(b"\\");
        joined.push_str(&String::from_utf8_lossy(continued.unwrap_or(text)));
        if joined.len() - line.start as usize > max_line {
            return Err(FileFault::LineTooLong { line: line.number, limit: max_line });
        }
        if continued.is_some() {
            joined.push(' ');
            continue;
        }
        line = finish(&mut lines, line, number + 1, joined.len())?;
    }
    finish(&mut lines, line, 0, joined.len())?;
    Ok((joined, lines))
}

/// Ends a line; the next one.
fn finish(lines: &mut Vec<Line>, line: Line, number: u32, end: usize) -> Result<Line, FileFault> {
    let start = u32::try_from(end).map_err(|_| FileFault::TooManyBytes(u32::MAX.into()))?;
    if start > line.start {
        lines.push(line);
    }
    Ok(Line { number, start })
}

fn physical_lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    // The pair CR LF ends one line: the empty piece between is not numbered.
    let mut rest = Some(bytes);
    std::iter::from_fn(move || {
        let whole = rest?;
        let Some(end) = whole.iter().position(|&byte| is_end(byte)) else {
            rest = None;
            return Some(whole);
        };
        let length = if whole[end..].starts_with(b"\r\n") { 2 } else { 1 };
        rest = Some(&whole[end + length..]);
        Some(&whole[..end])
    })
}

fn is_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<(u32, String)> {
        let file = Source::new(0, PathBuf::new(), PathBuf::new(), text.as_bytes(), 100).unwrap();
        let line = |index| file.line(index).map(|(number, text)| (number, text.to_string()));
        (0..).map_while(line).collect()
    }

    #[test]
    fn every_kind_of_line_end_counts_one_line() {
        for end in ["\n", "\r", "\r\n"] {
            let text = ["a", "", "b c", "d"].join(end);
            let expected = [(1, "a".into()), (3, "b c".into()), (4, "d".into())];
            assert_eq!(lines(&text), expected, "{end:?}");
        }
        assert_eq!(lines("a\n\rb"), [(1, "a".into()), (3, "b".into())]);
    }

    #[test]
    fn a_backslash_joins_whatever_the_line_end() {
        for end in ["\n", "\r", "\r\n"] {
            let text = ["a\\", "b\\", "c", "d", "# x\\", "y", "e"].join(end);
            let expected =
                [(1, "a b c".into()), (4, "d".into()), (5, "# x y".into()), (7, "e".into())];
            assert_eq!(lines(&text), expected, "{end:?}");
        }
        // Inside a line, or before a blank, it joins nothing.
        assert_eq!(lines("a\\b\\ \nc"), [(1, "a\\b\\ ".into()), (2, "c".into())]);
        assert_eq!(lines("a\\"), [(1, "a ".into())]);
    }

    #[test]
    fn a_byte_order_mark_is_no_word() {
        assert_eq!(lines("\u{feff}a b\nc"), [(1, "a b".into()), (2, "c".into())]);
    }

    #[test]
    fn long_lines_are_refused_with_their_number() {
        let text = format!("a\nb\\\n{}", "x".repeat(200));
        let fault = join(text.as_bytes(), 100).unwrap_err();
        assert!(matches!(fault, FileFault::LineTooLong { line: 2, limit: 100 }), "{fault}");
    }

    #[test]
    fn bytes_that_are_no_text_are_survived() {
        let source = Source::new(0, PathBuf::new(), PathBuf::new(), b"o caf\xe9\n", 100).unwrap();
        assert_eq!(source.line(0), Some((1, "o caf\u{fffd}")));
    }
}
