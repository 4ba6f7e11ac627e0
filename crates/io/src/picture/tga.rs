//! Truevision TGA, 24 bits, not compressed: the compression of the `image` crate
//! goes across rows, which the format forbids.

use super::Cause;
use super::screen::Screen;
use image::ExtendedColorType;
use image::codecs::tga::TgaEncoder;

/// The end of a file of version 2: no extensions, and the words by which a reader
/// knows the format.
const FOOTER: &[u8; 26] = b"\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0";

/// Type 2, rows from the top.
pub(super) fn encode(screen: &Screen) -> Result<Vec<u8>, Cause> {
    let mut bytes = Vec::new();
    let encoder = TgaEncoder::new(&mut bytes).disable_rle();
    encoder.encode(&screen.bytes, screen.width, screen.height, ExtendedColorType::Rgb8)?;
    bytes.extend(FOOTER);
    Ok(bytes)
}
