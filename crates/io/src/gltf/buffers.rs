//! Buffers: within the file, in `data:` addresses, or in files beside it.

use super::json::{Buffer, Root};
use super::{Cause, Error, Limits};
use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use std::borrow::Cow;

/// Brings the file of a name, or says why it does not.
pub(super) type Load<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// Brings all buffers of a file; `binary` is the one within it.
pub(super) fn all<'a>(
    root: &Root,
    binary: Option<&'a [u8]>,
    limits: Limits,
    load: Load<'_>,
) -> Result<Vec<Cow<'a, [u8]>>, Error> {
    let mut left = limits.bytes;
    let mut buffers = Vec::new();
    for (index, buffer) in root.buffers.iter().enumerate() {
        let here = |cause| Error::at(format!("buffers[{index}]"), cause);
        let binary = binary.filter(|_| index == 0);
        let bytes = bytes(buffer, binary, load).map_err(|why| here(Cause::Buffer(why)))?;
        left = left.checked_sub(bytes.len()).ok_or(Error::TooLong(limits.bytes))?;
        let there = bytes.len() as u64;
        if there < buffer.byte_length {
            return Err(here(Cause::TooFewBytes { needed: buffer.byte_length, there }));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

fn bytes<'a>(
    buffer: &Buffer,
    binary: Option<&'a [u8]>,
    load: Load<'_>,
) -> Result<Cow<'a, [u8]>, String> {
    match (&buffer.uri, binary) {
        (Some(uri), _) => data(uri).unwrap_or_else(|| load(&unescaped(uri))).map(Cow::Owned),
        (None, Some(binary)) => Ok(Cow::Borrowed(binary)),
        (None, None) => Err("it has no `uri`, and the file no such part".to_string()),
    }
}

/// Decodes the bytes of a `data:` address; `None` of any other.
pub(super) fn data(uri: &str) -> Option<Result<Vec<u8>, String>> {
    const CONFIG: GeneralPurposeConfig =
        GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    const ENGINE: GeneralPurpose = GeneralPurpose::new(&base64::alphabet::STANDARD, CONFIG);
    let (kind, text) = uri.strip_prefix("data:")?.split_once(',')?;
    if !kind.ends_with(";base64") {
        return Some(Err("its `data:` is not in base 64".to_string()));
    }
    Some(ENGINE.decode(text).map_err(|error| format!("its `data:` makes no sense: {error}")))
}

/// Decodes a name of a file, in which signs may stand as `%20`.
pub(super) fn unescaped(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let code = after.get(..2).filter(|_| first == b'%');
        let code = code.and_then(|code| std::str::from_utf8(code).ok());
        let code = code.and_then(|code| u8::from_str_radix(code, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
