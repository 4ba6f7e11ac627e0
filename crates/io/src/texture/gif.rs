//! GIF files whose screen has no size.
//!
//! Browsers show them as large as the first frame; the decoder shows nothing.

use std::borrow::Cow;

/// The offset of the screen's width and height, each a `u16`.
const SCREEN: usize = 6;

/// Signature and the screen's description.
const HEADER: usize = 13;

/// The file with a screen that the first frame fits on, if its own has no size.
pub(super) fn with_screen(file: &[u8]) -> Cow<'_, [u8]> {
    let size = file[SCREEN.min(file.len())..].first_chunk();
    let has_size = size.is_none_or(|&[a, b, c, d]| (a | b) != 0 && (c | d) != 0);
    let frame = if has_size { None } else { first_frame(file) };
    let Some(corners) = frame.and_then(|frame| file.get(frame..)?.first_chunk::<8>()) else {
        return Cow::Borrowed(file);
    };
    let reach = |at: usize| {
        let number = |at| u16::from_le_bytes([corners[at], corners[at + 1]]);
        number(at).saturating_add(number(at + 4)).to_le_bytes()
    };
    let mut file = file.to_vec();
    file[SCREEN..SCREEN + 4].copy_from_slice([reach(0), reach(2)].as_flattened());
    Cow::Owned(file)
}

/// Returns the offset of the first frame's column, row, width and height.
fn first_frame(file: &[u8]) -> Option<usize> {
    let flags = *file.get(SCREEN + 4)?;
    let colours = if flags & 0x80 == 0 { 0 } else { 2 << (flags & 7) };
    let mut at = HEADER + 3 * colours;
    while *file.get(at)? == 0x21 {
        // An extension: its kind, then blocks of which the last is empty.
        at += 2;
        while let length @ 1.. = usize::from(*file.get(at)?) {
            at += 1 + length;
        }
        at += 1;
    }
    (file[at] == 0x2c).then_some(at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A screen without size, two colours, a comment, a frame of 3 × 4 at 1, 2.
    const FILE: &[u8] =
        b"GIF89a\0\0\0\0\x80\0\0rgbrgb!\xfe\x01a\x02bc\0,\x01\0\x02\0\x03\0\x04\0\0";

    #[test]
    fn the_screen_is_as_large_as_the_first_frame_needs() {
        let found = with_screen(FILE);
        assert_eq!(found[..6], FILE[..6]);
        assert_eq!(found[6..10], [4, 0, 6, 0]);
        assert_eq!(found[10..], FILE[10..]);
        for length in 0..FILE.len() - 1 {
            assert_eq!(with_screen(&FILE[..length]), &FILE[..length]);
        }
        let sized = [&FILE[..6], &[9, 0, 9, 0], &FILE[10..]].concat();
        assert_eq!(with_screen(&sized), sized);
    }
}
