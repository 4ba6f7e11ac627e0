//! The chunks a 3DS file is made of.
//!
//! A chunk is an id (`u16`), a length (`u32`, its six bytes of header counted
//! too), data, and chunks inside. All numbers are little-endian.

use super::{WarningKind, Warnings};
use traylib_math::{Vec2, Vec3};

const HEADER: usize = 6;
const LONGEST_NAME: usize = 255;

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

    pub(super) fn vec2(&mut self) -> Option<Vec2> {
        self.floats().map(Vec2::from_array)
    }

    pub(super) fn vec3(&mut self) -> Option<Vec3> {
        self.floats().map(Vec3::from_array)
    }

    pub(super) fn floats<const N: usize>(&mut self) -> Option<[f32; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.f32()?;
        }
        Some(values)
    }

    /// The numbers this chunk begins with. `None`, and a warning, where bytes
    /// are lacking or one is infinite or not a number.
    pub(super) fn finite<const N: usize>(&mut self, warnings: &mut Warnings) -> Option<[f32; N]> {
        let Some(values) = self.floats() else {
            warnings.add(WarningKind::RecordCut);
            return None;
        };
        let finite = values.iter().all(|value: &f32| value.is_finite());
        if !finite {
            warnings.add(WarningKind::NumberNotFinite);
        }
        finite.then_some(values)
    }

    /// One number, as [`finite`](Self::finite).
    pub(super) fn number(&mut self, warnings: &mut Warnings) -> Option<f32> {
        self.finite(warnings).map(|[value]| value)
    }

    pub(super) fn skip(&mut self, count: usize) -> Option<()> {
        self.bytes = self.bytes.get(count..)?;
        Some(())
    }

    pub(super) fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Bytes up to a zero, or up to the end where there is none, as
    /// Windows-1252, which old programs wrote. Of longer names than anybody
    /// would write, and everything may repeat a name, only the beginning counts.
    pub(super) fn string(&mut self) -> String {
        let length = self.bytes.iter().position(|&b| b == 0).unwrap_or(self.bytes.len());
        let (text, rest) = self.bytes.split_at(length);
        self.bytes = rest.get(1..).unwrap_or_default();
        text.iter().take(LONGEST_NAME).map(|&b| windows_1252(b)).collect()
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

/// The character of a byte. The five that the code page leaves open are taken as
/// Latin-1 has them.
fn windows_1252(byte: u8) -> char {
    const FROM_128: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž',
        '\u{8f}', '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}',
        'ž', 'Ÿ',
    ];
    let high = byte.checked_sub(128).and_then(|place| FROM_128.get(usize::from(place)));
    high.copied().unwrap_or(char::from(byte))
}

/// Takes a value over where there is one.
pub(super) fn set<T>(field: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *field = value;
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
        assert_eq!(warnings.count(&WarningKind::ChunkCut), 1);
    }

    #[test]
    fn a_chunk_shorter_than_its_header_ends_the_parent() {
        for length in [0, 5] {
            let (found, warnings) = chunks(&[1, 0, length, 0, 0, 0, 2, 0, 6, 0, 0, 0]);
            assert_eq!(found, []);
            assert_eq!(warnings.count(&WarningKind::ChunkTooShort), 1);
        }
    }

    #[test]
    fn strings_end_at_zero_or_with_the_bytes() {
        let mut reader = Reader::new(b"ab\0c\xe9\x80\x9f");
        assert_eq!([reader.string(), reader.string(), reader.string()], ["ab", "cé€Ÿ", ""]);
    }

    #[test]
    fn of_an_endless_name_the_beginning_counts() {
        let mut reader = Reader::new(&[b'x'; 10_000]);
        assert_eq!((reader.string().len(), reader.len()), (LONGEST_NAME, 0));
    }

    #[test]
    fn numbers_are_there_and_finite_or_warned_about() {
        let mut warnings = Warnings::default();
        let bytes = [1.0_f32, 2.0, f32::NAN, 4.0].map(f32::to_le_bytes).concat();
        let mut reader = Reader::new(&bytes);
        assert_eq!(reader.finite(&mut warnings), Some([1.0, 2.0]));
        assert_eq!(reader.number(&mut warnings), None);
        assert_eq!(warnings.count(&WarningKind::NumberNotFinite), 1);
        assert_eq!(reader.finite::<2>(&mut warnings), None);
        assert_eq!(warnings.count(&WarningKind::RecordCut), 1);
    }

    #[test]
    fn a_list_takes_what_is_there() {
        let mut warnings = Warnings::default();
        let mut reader = Reader::new(&[0xff, 0xff, 1, 0, 2, 0, 3]);
        assert_eq!(reader.list(&mut warnings, Reader::u16), [1, 2]);
        assert_eq!(warnings.count(&WarningKind::ListCut), 1);
    }
}
