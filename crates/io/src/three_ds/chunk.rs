//! The chunks a 3DS file is made of.
//!
//! A chunk is an id (`u16`), a length (`u32`, its six bytes of header counted
//! too), data, and chunks inside. All numbers are little-endian.

use super::{WarningKind, Warnings};

const HEADER: usize = 6;

/// Reads forward through the bytes of one chunk. Nothing is read beyond them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reader<'a> {
    bytes: &'a [u8],
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (head, rest) = self.bytes.split_first_chunk::<N>()?;
        self.bytes = rest;
        Some(*head)
    }

    pub(super) fn byte(&mut self) -> Option<u8> {
        self.take::<1>().map(|[byte]| byte)
    }

    pub(super) fn u16(&mut self) -> Option<u16> {
        self.take().map(u16::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    pub(super) fn f32(&mut self) -> Option<f32> {
        self.take().map(f32::from_le_bytes)
    }

    /// Bytes up to a zero, or up to the end where there is none. Old programs
    /// wrote Windows-1252; bytes above 127 become the Latin-1 characters, which
    /// is enough to tell names apart.
    pub(super) fn string(&mut self) -> String {
        let length = self.bytes.iter().position(|&b| b == 0).unwrap_or(self.bytes.len());
        let (text, rest) = self.bytes.split_at(length);
        self.bytes = rest.get(1..).unwrap_or_default();
        text.iter().map(|&b| char::from(b)).collect()
    }

    /// Entries of a list that begins with its length as `u16`: as many as there
    /// are bytes for.
    pub(super) fn list<T>(
        &mut self,
        warnings: &mut Warnings,
        mut entry: impl FnMut(&mut Self) -> Option<T>,
    ) -> Vec<T> {
        let count = self.u16().map_or(0, usize::from);
        let mut entries = Vec::new();
        while entries.len() < count {
            let Some(value) = entry(self) else {
                warnings.add(WarningKind::ListCut);
                break;
            };
            entries.push(value);
        }
        entries
    }

    /// The next chunk inside this one, and past it. Fewer bytes than a header
    /// are padding.
    pub(super) fn next_chunk(&mut self, warnings: &mut Warnings) -> Option<(u16, Reader<'a>)> {
        if self.bytes.len() < HEADER {
            return None;
        }
        let id = self.u16()?;
        let length = self.u32()? as usize;
        let Some(mut wanted) = length.checked_sub(HEADER) else {
            warnings.add(WarningKind::ChunkTooShort);
            self.bytes = &[];
            return None;
        };
        if wanted > self.bytes.len() {
            warnings.add(WarningKind::ChunkCut);
            wanted = self.bytes.len();
        }
        let (body, rest) = self.bytes.split_at(wanted);
        self.bytes = rest;
        Some((id, Reader::new(body)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunks(bytes: &[u8]) -> (Vec<(u16, usize)>, Warnings) {
        let mut warnings = Warnings::default();
        let mut reader = Reader::new(bytes);
        let mut found = Vec::new();
        while let Some((id, body)) = reader.next_chunk(&mut warnings) {
            found.push((id, body.bytes.len()));
        }
        (found, warnings)
    }

    #[test]
    fn chunks_follow_one_another_and_padding_ends_them() {
        let (found, warnings) = chunks(&[1, 0, 7, 0, 0, 0, 9, 2, 0, 6, 0, 0, 0, 5, 5]);
        assert_eq!(found, [(1, 1), (2, 0)]);
        assert_eq!(warnings, Warnings::default());
    }

    #[test]
    fn a_chunk_beyond_its_parent_is_cut() {
        let (found, warnings) = chunks(&[1, 0, 0xff, 0xff, 0xff, 0xff, 9]);
        assert_eq!(found, [(1, 1)]);
        assert_eq!(warnings.count(WarningKind::ChunkCut), 1);
    }

    #[test]
    fn a_chunk_shorter_than_its_header_ends_the_parent() {
        for length in [0, 5] {
            let (found, warnings) = chunks(&[1, 0, length, 0, 0, 0, 2, 0, 6, 0, 0, 0]);
            assert_eq!(found, []);
            assert_eq!(warnings.count(WarningKind::ChunkTooShort), 1);
        }
    }

    #[test]
    fn strings_end_at_zero_or_with_the_bytes() {
        let mut reader = Reader::new(b"ab\0c\xe9");
        assert_eq!([reader.string(), reader.string(), reader.string()], ["ab", "cé", ""]);
    }

    #[test]
    fn a_list_takes_what_is_there() {
        let mut warnings = Warnings::default();
        let mut reader = Reader::new(&[0xff, 0xff, 1, 0, 2, 0, 3]);
        assert_eq!(reader.list(&mut warnings, Reader::u16), [1, 2]);
        assert_eq!(warnings.count(WarningKind::ListCut), 1);
    }
}
