//! The parts of a file.

use super::Error;

/// JSON text, and the first buffer of a binary file.
pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    pub(super) binary: Option<&'a [u8]>,
}

const JSON: [u8; 4] = *b"JSON";
const BINARY: [u8; 4] = *b"BIN\0";

/// Finds the parts of a binary file, or takes all of a text.
pub(super) fn parts(bytes: &[u8]) -> Result<Parts<'_>, Error> {
    if bytes.starts_with(b"glTF") {
        return of_binary(bytes);
    }
    let json = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let is_text = json.trim_ascii_start().starts_with(b"{");
    if is_text { Ok(Parts { json, binary: None }) } else { Err(Error::NotGltf) }
}

fn of_binary(bytes: &[u8]) -> Result<Parts<'_>, Error> {
    let version = number(bytes, 4)?;
    if version != 2 {
        return Err(Error::Version(version.to_string()));
    }
    let length = number(bytes, 8)? as usize;
    if length > bytes.len() {
        return Err(Error::Container { byte: 8, what: "the file is shorter than it says" });
    }
    // What follows is not part of it.
    let bytes = &bytes[..length];
    let (mut at, mut json, mut binary) = (12, None, None);
    while at + 8 <= bytes.len() {
        let length = number(bytes, at)? as usize;
        let kind = &bytes[at + 4..at + 8];
        let rest = &bytes[at + 8..];
        let what = "the chunk is longer than the file";
        let chunk = rest.get(..length).ok_or(Error::Container { byte: at, what })?;
        if json.is_none() && kind == JSON {
            json = Some(chunk);
        } else if binary.is_none() && kind == BINARY {
            binary = Some(chunk);
        }
        at += 8 + length;
    }
    let what = "it has no JSON";
    Ok(Parts { json: json.ok_or(Error::Container { byte: 12, what })?, binary })
}

fn number(bytes: &[u8], at: usize) -> Result<u32, Error> {
    let four = bytes.get(at..).and_then(<[u8]>::first_chunk);
    let what = "the file ends";
    four.map(|four| u32::from_le_bytes(*four)).ok_or(Error::Container { byte: at, what })
}
