//! Small pictures as the bytes of files.

use crate::relations::scene::{Coding, Picture};

/// The ending of the file's name, and what is in it.
pub(super) fn file(picture: &Picture) -> (&str, Vec<u8>) {
    match picture {
        Picture::File { ending, content } => (ending, content.clone()),
        Picture::Texels { width, texels, coding } => {
            let size = [*width, texels.len() / width];
            match coding {
                Coding::Hdr => ("hdr", hdr(size, texels)),
                Coding::Tga => ("tga", tga(size, texels)),
            }
        }
    }
}

/// Radiance's format, not compressed: 256ths exactly.
fn hdr([width, height]: [usize; 2], texels: &[[u8; 3]]) -> Vec<u8> {
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n".to_vec();
    bytes.extend(format!("-Y {height} +X {width}\n").bytes());
    // The exponent 128 stands for mantissas in 256ths.
    bytes.extend(texels.iter().flat_map(|&[r, g, b]| [r, g, b, 128]));
    bytes
}

/// TGA of true colour, not compressed, from the top.
fn tga(size: [usize; 2], texels: &[[u8; 3]]) -> Vec<u8> {
    let [width, height] = size.map(|side| (side as u16).to_le_bytes());
    let mut bytes = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    bytes.extend([width[0], width[1], height[0], height[1], 24, 0x20]);
    bytes.extend(texels.iter().flat_map(|&[r, g, b]| [b, g, r]));
    bytes
}
