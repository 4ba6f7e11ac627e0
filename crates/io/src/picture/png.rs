//! PNG, 8 bits a channel.
//!
//! By the crate that the `image` crate writes PNG with: that one passes no text on,
//! and does not say that the curve is sRGB.

use super::Cause;
use super::screen::Screen;
use png::{BitDepth, ColorType, Compression, Encoder, SrgbRenderingIntent};

/// Attributes become text in UTF-8, but for those whose name PNG has no place for.
pub(super) fn encode(screen: &Screen, attributes: &[(String, String)]) -> Result<Vec<u8>, Cause> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, screen.width, screen.height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    for (name, text) in attributes.iter().filter(|(name, _)| is_keyword(name)) {
        encoder.add_itxt_chunk(name.clone(), text.replace('\0', " "))?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&screen.bytes)?;
    writer.finish()?;
    Ok(bytes)
}

/// 1 to 79 printable characters.
fn is_keyword(name: &str) -> bool {
    (1..80).contains(&name.len()) && name.bytes().all(|byte| (b' '..=b'~').contains(&byte))
}
