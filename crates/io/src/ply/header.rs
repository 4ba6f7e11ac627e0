//! The header of a file, which says what it holds.

use super::body::{Body, Coding};
use super::declaration::{Element, Property};
use super::kind::{Kind, Number};
use super::{Cause, Error, WarningKind};
use crate::suggest::shown;
use crate::warning_counts::WarningCounts;

/// The header of a file, which says what it holds.
#[derive(Debug, Default)]
pub(super) struct Header {
    pub(super) elements: Vec<Element>,
    /// Pictures that comments name.
    pub(super) textures: Vec<String>,
    pub(super) warnings: WarningCounts<WarningKind>,
}

/// Reads the header, and returns what follows it.
pub(super) fn read(bytes: &[u8]) -> Result<(Header, Body<'_>), Error> {
    let mut lines = Lines { bytes, at: 0, line: 0, ends_in_return: false };
    if lines.next().is_none_or(|first| first != "ply") {
        return Err(Error::NotPly);
    }
    let (mut header, mut coding) = (Header::default(), None);
    loop {
        let text = lines.next().ok_or(Error::HeaderEnds)?;
        if text == "end_header" {
            break;
        }
        let line = lines.line;
        header.line(&text, &mut coding).map_err(|cause| Error::Header { line, cause })?;
    }
    let failed = Error::Header { line: lines.line, cause: Cause::NoFormat };
    let coding = coding.ok_or(failed)?;
    Ok((header, Body::new(coding, bytes, lines.at, lines.line)))
}

impl Header {
    fn line(&mut self, text: &str, coding: &mut Option<Coding>) -> Result<(), Cause> {
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        match words[..] {
            ["comment", "TextureFile", ..] => {
                let name = text.split_once("TextureFile").map_or("", |(_, name)| name.trim());
                self.textures.push(name.to_string());
            }
            [] | ["comment" | "obj_info", ..] => {}
            ["format", name, _] => {
                *coding = Some(Coding::of(name).ok_or_else(|| Cause::Format(shown(name)))?);
            }
            ["element", name, count] => {
                let count = count.parse().map_err(|_| Cause::NotANumber(shown(count)))?;
                let name = name.to_string();
                self.elements.push(Element { name, count, properties: Vec::new() });
            }
            ["property", "list", length, item, name] => {
                self.property(name, Kind::List(Number::of(length)?, Number::of(item)?))?;
            }
            ["property", kind, name] => self.property(name, Kind::One(Number::of(kind)?))?,
            ["format" | "element" | "property", ..] => return Err(Cause::Line(shown(text))),
            // Some writers break their comments.
            _ => self.warnings.add(WarningKind::HeaderLine),
        }
        Ok(())
    }

    fn property(&mut self, name: &str, kind: Kind) -> Result<(), Cause> {
        let element = self.elements.last_mut().ok_or(Cause::NoElement)?;
        element.properties.push(Property { name: name.to_string(), kind });
        Ok(())
    }
}

/// Lines that end in a line feed, a carriage return, or both.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    /// The first line ended in a carriage return alone, so that a line feed is of the data.
    ends_in_return: bool,
}

impl Lines<'_> {
    /// Returns the next line in any coding, without blanks around it.
    fn next(&mut self) -> Option<String> {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
        let is_pair = !self.ends_in_return && rest[length..].starts_with(b"\r\n");
        if self.line == 0 {
            self.ends_in_return = !is_pair && rest[length] == b'\r';
        }
        self.at += length + if is_pair { 2 } else { 1 };
        self.line = self.line.saturating_add(1);
        Some(String::from_utf8_lossy(rest[..length].trim_ascii()).into_owned())
    }
}
