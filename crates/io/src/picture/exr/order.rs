//! The attributes of a header in a fixed order.
//!
//! The `exr` crate keeps attributes in a hash table and writes them as that happens
//! to list them. Their order means nothing, and moving them moves nothing else.

/// Magic number and version.
const BEGIN: usize = 8;

/// A file of one part with its attributes by name; `None` if its header has no end.
pub(super) fn sorted(mut file: Vec<u8>) -> Option<Vec<u8>> {
    let mut attributes = Vec::new();
    let mut at = BEGIN;
    while *file.get(at)? != 0 {
        let end = at.checked_add(length(file.get(at..)?)?)?;
        attributes.push(file.get(at..end)?.to_vec());
        at = end;
    }
    attributes.sort();
    file[BEGIN..at].copy_from_slice(&attributes.concat());
    Some(file)
}

/// Bytes of the first attribute: name and kind with a zero behind each, how long the
/// value is, the value.
fn length(attributes: &[u8]) -> Option<usize> {
    let name = 1 + attributes.iter().position(|&byte| byte == 0)?;
    let kind = 1 + attributes.get(name..)?.iter().position(|&byte| byte == 0)?;
    let size = attributes.get(name + kind..)?.first_chunk()?;
    (name + kind + size_of_val(size)).checked_add(u32::from_le_bytes(*size) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attributes_are_sorted_and_the_rest_stays() {
        let file = b"12345678b\0t\0\x01\0\0\0za\0int\0\0\0\0\0\0pixels";
        let expected = b"12345678a\0int\0\0\0\0\0b\0t\0\x01\0\0\0z\0pixels";
        assert_eq!(sorted(file.to_vec()).unwrap(), expected);
        for length in 0..file.len() - b"\0pixels".len() {
            assert_eq!(sorted(file[..length].to_vec()), None, "{length}");
        }
        assert_eq!(sorted(b"12345678a\0b\0\xff\xff\xff\xff".to_vec()), None);
    }
}
