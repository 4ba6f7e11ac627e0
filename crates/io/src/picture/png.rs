//! PNG, 8 bits a channel.
//!
//! Writes by the crate that the `image` crate writes PNG with: that one passes no text on,
//! and does not say that the curve is sRGB.

use super::Cause;
use super::screen::Screen;
use png::{BitDepth, ColorType, Compression, Decoder, Encoder, SrgbRenderingIntent};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

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

/// The texts of a PNG file that stand before its pixels, name and text; none if it
/// cannot be read.
pub fn png_texts(path: &Path) -> Vec<(String, String)> {
    let Ok(file) = File::open(path) else { return Vec::new() };
    let Ok(reader) = Decoder::new(BufReader::new(file)).read_info() else { return Vec::new() };
    let info = reader.info();
    let utf8 = info.utf8_text.iter();
    let utf8 = utf8.filter_map(|text| Some((text.keyword.clone(), text.get_text().ok()?)));
    let latin1 = info.uncompressed_latin1_text.iter();
    let latin1 = latin1.map(|text| (text.keyword.clone(), text.text.clone()));
    let packed = info.compressed_latin1_text.iter();
    let packed = packed.filter_map(|text| Some((text.keyword.clone(), text.get_text().ok()?)));
    utf8.chain(latin1).chain(packed).collect()
}
