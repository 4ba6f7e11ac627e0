//! Small files of each format.

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

/// One of each format, and of each way to compress.
pub(super) fn all(width: u16, height: u16) -> Vec<(&'static str, Vec<u8>)> {
    let (w, h) = (u32::from(width), u32::from(height));
    let rgb: Vec<u8> = (0..3 * w * h).map(|i| (i * 37) as u8).collect();
    let rgba: Vec<u8> = (0..4 * w * h).map(|i| (i * 37) as u8).collect();
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(&rgba, w, h, ExtendedColorType::Rgba8).unwrap();
    let mut jpeg = Vec::new();
    JpegEncoder::new(&mut jpeg).write_image(&rgb, w, h, ExtendedColorType::Rgb8).unwrap();
    // Enough for rows that are filled up.
    let body = rgb.repeat(4);
    let runs: Vec<u8> = (0..w * h).flat_map(|i| [0x80, i as u8, 1, 2]).collect();
    let map = [&[0; 768][..], &rgb].concat();
    vec![
        ("png", png),
        ("jpeg", jpeg),
        ("gif", gif(width, height, false)),
        ("interlaced gif", gif(width, height, true)),
        ("tga", tga(2, (0, 0, 0), (width, height), 24, 0, &rgb)),
        ("tga of runs", tga(10, (0, 0, 0), (width, height), 24, 0x20, &runs)),
        ("tga with a map", tga(1, (0, 256, 24), (width, height), 8, 0, &map)),
        ("pcx of 24 bits", pcx(8, 3, (width, height), width, &body)),
        ("pcx of 1 bit", pcx(1, 1, (width, height), width, &body)),
        ("pcx of 4 planes", pcx(1, 4, (width, height), 2, &[&body[..], &body, &body].concat())),
        ("hdr", hdr(w, h)),
        ("bmp of 24 bits", bmp(24, (w, h), &[], &body)),
        ("bmp of 8 bits", bmp(8, (w, h), &[7; 4 * 256], &body)),
    ]
}

/// Pixel i has the colour (i, 2i, 255 - i); at most 120 pixels. Codes have 8 bits as
/// long as the table of strings is small, so that they are bytes.
pub(super) fn gif(width: u16, height: u16, interlaced: bool) -> Vec<u8> {
    let ([w, v], [h, g]) = (width.to_le_bytes(), height.to_le_bytes());
    let mut file = b"GIF89a".to_vec();
    file.extend([w, v, h, g, 0x80 | 6, 0, 0]);
    file.extend((0..128).flat_map(|i| [i, 2 * i, 255 - i]));
    file.extend([0x2c, 0, 0, 0, 0, w, v, h, g, if interlaced { 0x40 } else { 0 }, 7]);
    let rows: Vec<u16> = if interlaced { interlaced_rows(height) } else { (0..height).collect() };
    let pixels = rows.into_iter().flat_map(|row| row * width..(row + 1) * width);
    let codes: Vec<u8> = [0x80].into_iter().chain(pixels.map(|i| i as u8)).chain([0x81]).collect();
    file.push(codes.len() as u8);
    file.extend(codes);
    file.extend([0, 0x3b]);
    file
}

fn interlaced_rows(height: u16) -> Vec<u16> {
    let pass = |(first, step)| (first..height).step_by(step);
    [(0, 8), (4, 8), (2, 4), (1, 2)].into_iter().flat_map(pass).collect()
}

/// Type; first, length and bits of the colour map; size; bits; descriptor; the rest.
pub(super) fn tga(
    kind: u8,
    (first, length, map_bits): (u16, u16, u8),
    (width, height): (u16, u16),
    bits: u8,
    descriptor: u8,
    rest: &[u8],
) -> Vec<u8> {
    let mut file = vec![3, u8::from(map_bits > 0), kind];
    file.extend([first, length].iter().flat_map(|n| n.to_le_bytes()));
    file.extend([map_bits, 9, 9, 9, 9]);
    file.extend([width, height].iter().flat_map(|n| n.to_le_bytes()));
    file.extend([bits, descriptor]);
    file.extend(b"id.");
    file.extend(rest);
    file
}

/// Bits, planes, size, bytes of a row of a plane, rows. Not compressed. Colour i of
/// the header is (i, 2i, 3i) times 5.
pub(super) fn pcx(
    bits: u8,
    planes: u8,
    (width, height): (u16, u16),
    row: u16,
    body: &[u8],
) -> Vec<u8> {
    let mut file = vec![10, 5, 0, bits];
    // From column 7 and row 5.
    let corners = [7, 5, width + 6, height + 4, 72, 72];
    file.extend(corners.iter().flat_map(|n: &u16| n.to_le_bytes()));
    file.extend((0..16).flat_map(|i| [5 * i, 10 * i, 15 * i]));
    file.extend([0, planes]);
    file.extend(row.to_le_bytes());
    file.resize(128, 0);
    file.extend(body);
    file
}

/// Bits, size, palette of blue, green, red and nothing; rows from the bottom, each
/// filled to a multiple of four bytes. Of 32 bits with a place for opacity.
pub(super) fn bmp(bits: u8, (width, height): (u32, u32), palette: &[u8], body: &[u8]) -> Vec<u8> {
    let masks: &[u32] = if bits == 32 { &[0xff_0000, 0xff00, 0xff, 0xff00_0000] } else { &[] };
    let header = if bits == 32 { 56 } else { 40 };
    let pixels = 14 + header + palette.len() as u32;
    let row = (width * u32::from(bits)).div_ceil(32) * 4;
    let mut file = b"BM".to_vec();
    let words = [pixels + row * height, 0, pixels, header, width, height];
    file.extend(words.iter().flat_map(|n| n.to_le_bytes()));
    file.extend([1, 0, bits, 0, if bits == 32 { 3 } else { 0 }]);
    file.resize(54, 0);
    file.extend(masks.iter().flat_map(|n| n.to_le_bytes()));
    file.extend(palette);
    file.extend(&body[..(row * height) as usize]);
    file
}

fn hdr(width: u32, height: u32) -> Vec<u8> {
    let mut file = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n");
    file.push_str(&"@ A~".repeat((width * height) as usize));
    file.into_bytes()
}
