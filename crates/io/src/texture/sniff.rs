//! Recognises the format of a file.

use std::path::Path;

/// The first bytes of an EXR file.
pub(super) const EXR: &[u8] = &[0x76, 0x2f, 0x31, 0x01];

const SIGNATURES: [(&[u8], Format); 5] = [
    (b"\x89PNG\r\n\x1a\n", Format::Png),
    (b"\xff\xd8\xff", Format::Jpeg),
    (b"GIF87a", Format::Gif),
    (b"GIF89a", Format::Gif),
    // A program's name follows: RADIANCE, RGBE, AUTOPANO and others.
    (b"#?", Format::Hdr),
];

/// The last bytes of a TGA file of version 2.
const TGA_FOOTER: &[u8] = b"TRUEVISION-XFILE.\0";

/// The formats that are decoded from bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Png,
    Jpeg,
    Gif,
    Bmp,
    Tga,
    Pcx,
    Hdr,
}

impl Format {
    /// Content goes before the name, which says no more than that a file without the
    /// marks of any format is a damaged TGA file.
    pub(super) fn of(bytes: &[u8], name: &Path) -> Option<Self> {
        let signed = SIGNATURES.iter().find(|(begin, _)| bytes.starts_with(begin));
        let pcx = || is_pcx(bytes).then_some(Self::Pcx);
        let tga = || is_tga(bytes, name).then_some(Self::Tga);
        let bmp = || is_bmp(bytes).then_some(Self::Bmp);
        signed.map(|&(_, format)| format).or_else(bmp).or_else(pcx).or_else(tga)
    }
}

/// Two letters, and how long the second header is: of OS/2, of Windows 3, or one of its
/// longer ones.
fn is_bmp(bytes: &[u8]) -> bool {
    let second = bytes.get(14..18).and_then(|size| size.first_chunk().copied());
    let length = second.map(u32::from_le_bytes);
    bytes.starts_with(b"BM") && matches!(length, Some(12 | 16 | 40 | 52 | 56 | 64 | 108 | 124))
}

/// A number, a version, whether it is compressed, bits. No TGA file begins so: one
/// with 10 bytes of text and without colours of its own is of type 2 or more.
fn is_pcx(bytes: &[u8]) -> bool {
    matches!(bytes, [0x0a, 0 | 2..=5, 0 | 1, 1 | 2 | 4 | 8, ..])
}

fn is_tga(bytes: &[u8], name: &Path) -> bool {
    let named = || name.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("tga"));
    bytes.ends_with(TGA_FOOTER) || has_tga_header(bytes) || named()
}

/// Tells whether the header agrees with itself: a map of colours where the kind of picture
/// needs one, numbers of bits that there are, a size, and no bits that are not used.
fn has_tga_header(bytes: &[u8]) -> bool {
    let Some(header) = bytes.first_chunk::<18>() else { return false };
    let &[_, map, kind, _, _, m0, m1, map_bits, _, _, _, _, w0, w1, h0, h1, bits, flags] = header;
    let sound_map = match map {
        0 => true,
        1 => m0 | m1 != 0 && matches!(map_bits, 15 | 16 | 24 | 32),
        _ => return false,
    };
    let sound_bits = match kind {
        1 | 9 => map == 1 && matches!(bits, 8 | 16),
        2 | 10 => matches!(bits, 15 | 16 | 24 | 32),
        3 | 11 => matches!(bits, 8 | 16),
        _ => false,
    };
    sound_map && sound_bits && w0 | w1 != 0 && h0 | h1 != 0 && flags & 0xc0 == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_goes_before_the_name() {
        for (bytes, name, expected) in [
            (&b"GIF89a..."[..], "a.png", Some(Format::Gif)),
            (b"\xff\xd8\xff\xe0", "a.tga", Some(Format::Jpeg)),
            (b"#?AUTOPANO\n", "a.tga", Some(Format::Hdr)),
            (b"GIF90a...", "a.gif", None),
            (b"GIF90a...", "a.TGA", Some(Format::Tga)),
            (b"...TRUEVISION-XFILE.\0", "a", Some(Format::Tga)),
            (b"BM............\x28\0\0\0", "a.tga", Some(Format::Bmp)),
            (b"BM............\x29\0\0\0", "a.bmp", None),
            (b"\x0a\x05\x01\x08", "a", Some(Format::Pcx)),
            (b"\x0a\x00\x02\x00", "a.tga", Some(Format::Tga)),
            (b"", "a.hdr", None),
        ] {
            assert_eq!(Format::of(bytes, Path::new(name)), expected, "{name}");
        }
    }

    #[test]
    fn tga_is_known_by_its_header() {
        let sound = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 3, 0, 24, 0x20];
        let of = |header: &[u8]| Format::of(header, Path::new("a.png"));
        assert_eq!(of(&sound), Some(Format::Tga));
        assert_eq!(of(&sound[..17]), None);
        // Another map, kind, width, number of bits, and a bit that is not used.
        for (at, byte) in [(1, 2), (1, 1), (2, 4), (2, 1), (12, 0), (16, 23), (17, 0x40)] {
            let mut other = sound;
            other[at] = byte;
            assert_eq!(of(&other), None, "{at}");
        }
    }
}
