//! Lines of text that may go on in the next.

use std::borrow::Cow;

/// Statements with the lines in which they begin, from 1. Blank lines and comments are left
/// out; a line that ends in `\` goes on in the next, unless it is a comment.
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

    /// The next line without its end and without blanks around it.
    fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.line = self.line.saturating_add(1);
        let end = self.rest.iter().position(|&byte| byte == b'\n');
        let (line, rest) = match end {
            Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
            None => (self.rest, &self.rest[self.rest.len()..]),
        };
        self.rest = rest;
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
}
