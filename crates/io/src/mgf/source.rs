//! The text of a file, cut into lines.

use super::FileFault;
use std::ops::Range;
use std::path::PathBuf;

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

#[derive(Debug)]
struct Line {
    number: u32,
    range: Range<usize>,
}

impl Source {
    /// Takes a file apart. Bytes that are no text become replacement marks.
    pub(super) fn new(
        id: usize,
        shown: PathBuf,
        path: PathBuf,
        bytes: Vec<u8>,
        max_line: usize,
    ) -> Result<Self, FileFault> {
        let text = match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
        };
        let (text, lines) = join(&text, max_line)?;
        Ok(Self { id, shown, path, text, lines })
    }

    /// A joined line and its number in the file.
    pub(super) fn line(&self, index: usize) -> Option<(u32, &str)> {
        let line = self.lines.get(index)?;
        Some((line.number, &self.text[line.range.clone()]))
    }
}

/// Text and lines with continuations joined by a blank. A line ends with LF, CR
/// or CR LF; a backslash before any of these joins the next one. Empty lines
/// are left out.
fn join(text: &str, max_line: usize) -> Result<(String, Vec<Line>), FileFault> {
    let mut joined = String::with_capacity(text.len());
    let mut lines = Vec::new();
    let (mut start, mut first) = (0, 1);
    for (number, line) in (1..).zip(physical_lines(text)) {
        let continued = line.strip_suffix('\\');
        joined.push_str(continued.unwrap_or(line));
        if joined.len() - start > max_line {
            return Err(FileFault::LineTooLong { line: first, limit: max_line });
        }
        if continued.is_some() {
            joined.push(' ');
            continue;
        }
        finish(&mut lines, first, start..joined.len());
        (start, first) = (joined.len(), number + 1);
    }
    finish(&mut lines, first, start..joined.len());
    Ok((joined, lines))
}

fn finish(lines: &mut Vec<Line>, number: u32, range: Range<usize>) {
    if !range.is_empty() {
        lines.push(Line { number, range });
    }
}

fn physical_lines(text: &str) -> impl Iterator<Item = &str> {
    // The pair CR LF ends one line: the empty piece between is not numbered.
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let whole = rest?;
        let Some(end) = whole.find(['\n', '\r']) else {
            rest = None;
            return Some(whole);
        };
        let length = if whole[end..].starts_with("\r\n") { 2 } else { 1 };
        rest = Some(&whole[end + length..]);
        Some(&whole[..end])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<(u32, String)> {
        let (text, lines) = join(text, 100).unwrap();
        lines.into_iter().map(|line| (line.number, text[line.range].to_string())).collect()
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
    fn long_lines_are_refused_with_their_number() {
        let text = format!("a\nb\\\n{}", "x".repeat(200));
        let fault = join(&text, 100).unwrap_err();
        assert!(matches!(fault, FileFault::LineTooLong { line: 2, limit: 100 }), "{fault}");
    }

    #[test]
    fn bytes_that_are_no_text_are_survived() {
        let source =
            Source::new(0, PathBuf::new(), PathBuf::new(), b"o caf\xe9\n".to_vec(), 100).unwrap();
        assert_eq!(source.line(0), Some((1, "o caf\u{fffd}")));
    }
}
