//! Lines of text that may go on in the next.

use std::borrow::Cow;

/// Iterates over statements with the lines in which they begin, from 1. Lines end in a line
/// feed, a carriage return, or both. Blank lines and comments are left out; a line that ends in
/// `\` goes on in the next, unless it is a comment.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    line: u32,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        // The byte order mark, which some editors put in front.
        let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        Self { rest, line: 0 }
    }

    /// Returns the next line without its end and without blanks around it.
    fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.line = self.line.saturating_add(1);
        let end = self.rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        let after = rest.strip_prefix(b"\r\n").or_else(|| rest.get(1..));
        self.rest = after.unwrap_or_default();
        Some(line.trim_ascii())
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (u32, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let line = loop {
            let line = self.line()?;
            if !line.is_empty() && !line.starts_with(b"#") {
                break line;
            }
        };
        let number = self.line;
        let Some(begun) = line.strip_suffix(b"\\") else { return Some((number, line.into())) };
        let mut whole = begun.to_vec();
        while let Some(line) = self.line() {
            whole.push(b' ');
            let more = line.strip_suffix(b"\\");
            whole.extend_from_slice(more.unwrap_or(line));
            if more.is_none() {
                break;
            }
        }
        Some((number, whole.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_go_on_after_a_backslash() {
        let text = b"\xef\xbb\xbf# a\\\r\n\r\nf 1 2 \\\r\n 3 \\\n4\n  g x\nend\\";
        let found: Vec<_> =
            Lines::new(text).map(|(n, line)| (n, String::from_utf8_lossy(&line).into())).collect();
        let wanted = [(3, "f 1 2  3  4"), (6, "g x"), (7, "end")];
        assert_eq!(found, wanted.map(|(n, line)| (n, line.to_string())));
    }

    #[test]
    fn lines_end_as_on_any_machine() {
        let said = |text: &str| {
            let lines = Lines::new(text.as_bytes());
            lines.map(|(n, line)| (n, line.into_owned())).collect::<Vec<_>>()
        };
        let text = "v 1\n# c\n\nf 1 \\\n2\n";
        let unix = said(text);
        assert_eq!(unix, [(1, b"v 1".to_vec()), (4, b"f 1  2".to_vec())]);
        assert_eq!(said(&text.replace('\n', "\r\n")), unix);
        assert_eq!(said(&text.replace('\n', "\r")), unix);
    }
}
