//! Which format a file is of.

use std::path::Path;

/// How an EXR file begins.
pub(super) const EXR: &[u8] = &[0x76, 0x2f, 0x31, 0x01];

const SIGNATURES: [(&[u8], Format); 6] = [
    (b"\x89PNG\r\n\x1a\n", Format::Png),
    (b"\xff\xd8\xff", Format::Jpeg),
    (b"GIF87a", Format::Gif),
    (b"GIF89a", Format::Gif),
    (b"#?RADIANCE", Format::Hdr),
    (b"#?RGBE", Format::Hdr),
];

/// How a TGA file of version 2 ends.
const TGA_FOOTER: &[u8] = b"TRUEVISION-XFILE.\0";

/// The formats that are decoded from bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Png,
    Jpeg,
    Gif,
    Tga,
    Pcx,
    Hdr,
}

impl Format {
    /// Content goes before the name.
    pub(super) fn of(bytes: &[u8], name: &Path) -> Option<Self> {
        let signed = SIGNATURES.iter().find(|(begin, _)| bytes.starts_with(begin));
        let pcx = || is_pcx(bytes).then_some(Self::Pcx);
        let tga = || is_tga(bytes, name).then_some(Self::Tga);
        signed.map(|&(_, format)| format).or_else(pcx).or_else(tga)
    }
}

/// A number, a version, whether it is compressed, bits. No TGA file begins so: one
/// with 10 bytes of text and without colours of its own is of type 2 or more.
fn is_pcx(bytes: &[u8]) -> bool {
    matches!(bytes, [0x0a, 0 | 2..=5, 0 | 1, 1 | 2 | 4 | 8, ..])
}

fn is_tga(bytes: &[u8], name: &Path) -> bool {
    let named = name.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("tga"));
    named || bytes.ends_with(TGA_FOOTER)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_goes_before_the_name() {
        for (bytes, name, expected) in [
            (&b"GIF89a..."[..], "a.png", Some(Format::Gif)),
            (b"\xff\xd8\xff\xe0", "a.tga", Some(Format::Jpeg)),
            (b"GIF90a...", "a.gif", None),
            (b"GIF90a...", "a.TGA", Some(Format::Tga)),
            (b"...TRUEVISION-XFILE.\0", "a", Some(Format::Tga)),
            (b"\x0a\x05\x01\x08", "a", Some(Format::Pcx)),
            (b"\x0a\x00\x02\x00", "a.tga", Some(Format::Tga)),
            (b"", "a.hdr", None),
        ] {
            assert_eq!(Format::of(bytes, Path::new(name)), expected, "{name}");
        }
    }
}
