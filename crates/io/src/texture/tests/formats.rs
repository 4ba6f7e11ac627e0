//! Readers of each format against files made for it.

use super::*;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

#[test]
fn interlaced_rows_are_put_in_order() {
    for side in [1, 2, 3, 4, 5, 7, 8, 9, 10] {
        let expected: Vec<_> = (0..side * side).map(|i| [i, 2 * i, 255 - i, 255]).collect();
        for interlaced in [false, true] {
            let found = read(&made::gif(side.into(), side.into(), interlaced)).unwrap();
            assert_eq!(rgba8(&found), expected, "{side} {interlaced}");
            assert_eq!((found.alpha, found.warnings.len()), (None, 0));
        }
    }
}

/// The frame of a GIF on a screen of 3 × 3.
fn on_screen(left: u8, top: u8) -> Texture {
    let mut file = made::gif(2, 2, false);
    (file[6], file[8]) = (3, 3);
    // After the header and 128 colours.
    let frame = 13 + 3 * 128;
    (file[frame + 1], file[frame + 3]) = (left, top);
    // Colour 1 is transparent.
    file.splice(frame..frame, [0x21, 0xf9, 4, 1, 0, 0, 1, 0]);
    read(&file).unwrap()
}

#[test]
fn a_frame_stands_on_its_screen() {
    let (none, [a, _, c, d]) = ([0; 4], [0, 1, 2, 3].map(|i| [i, 2 * i, 255 - i, 255]));
    let found = on_screen(1, 1);
    let b = rgba8(&found)[5];
    assert_eq!(rgba8(&found), [none, none, none, none, a, b, none, c, d]);
    assert_eq!(b[3], 0);
    // Cut where it stands out.
    assert_eq!(rgba8(&on_screen(2, 2))[8], a);
}

#[test]
fn tga_rows_and_columns_go_four_ways() {
    let pixels = [1, 2, 3, 4, 5, 6].map(|i| [i, 0, 0]);
    for (descriptor, order) in [
        (0x00, [4, 5, 6, 1, 2, 3]),
        (0x10, [6, 5, 4, 3, 2, 1]),
        (0x20, [1, 2, 3, 4, 5, 6]),
        (0x30, [3, 2, 1, 6, 5, 4]),
    ] {
        let file = made::tga(2, (0, 0, 0), (3, 2), 24, descriptor, pixels.as_flattened());
        let found = texture_from_bytes(&file, Path::new("a.tga"), TextureLimits::default());
        // Blue comes first in the file.
        assert_eq!(rgba8(&found.unwrap()), order.map(|i| [0, 0, i, 255]), "{descriptor:#x}");
    }
}

/// A TGA file of one row.
#[track_caller]
fn tga(
    kind: u8,
    map: (u16, u16, u8),
    width: u16,
    bits: u8,
    alpha: u8,
    rest: &[u8],
) -> Vec<[u8; 4]> {
    let file = made::tga(kind, map, (width, 1), bits, 0x20 | alpha, rest);
    rgba8(&texture_from_bytes(&file, Path::new("a.TGA"), TextureLimits::default()).unwrap())
}

#[test]
fn tga_has_many_kinds_of_pixels() {
    let none = (0, 0, 0);
    assert_eq!(tga(3, none, 2, 8, 0, &[7, 200]), [[7, 7, 7, 255], [200, 200, 200, 255]]);
    let bytes = [1, 2, 3, 4, 5, 6, 7, 0];
    assert_eq!(tga(2, none, 2, 32, 8, &bytes), [[3, 2, 1, 4], [7, 6, 5, 0]]);
    // The header says that the fourth byte is not opacity.
    assert_eq!(tga(2, none, 2, 32, 0, &bytes), [[3, 2, 1, 255], [7, 6, 5, 255]]);
    // Red 1, green 0, blue 31 of 31; the highest bit is not looked at.
    assert_eq!(tga(2, none, 2, 16, 1, &[0x1f, 0x04, 0x1f, 0x84]), [[8, 0, 255, 255]; 2]);
    // A run across rows, as some programs write it, and one that is too long.
    let runs = [0x84, 1, 2, 3];
    assert_eq!(tga(10, none, 4, 24, 0, &runs), [[3, 2, 1, 255]; 4]);
    let map = [10, 11, 12, 20, 21, 22, 1, 0];
    assert_eq!(tga(1, (0, 2, 24), 2, 8, 0, &map), [[22, 21, 20, 255], [12, 11, 10, 255]]);
    // The first colour is number 100.
    let map = [10, 11, 12, 20, 21, 22, 101, 100];
    assert_eq!(tga(1, (100, 2, 24), 2, 8, 0, &map), [[22, 21, 20, 255], [12, 11, 10, 255]]);
    // A map that nothing refers to.
    assert_eq!(tga(2, (0, 1, 24), 1, 24, 0, &[9, 9, 9, 1, 2, 3]), [[3, 2, 1, 255]]);
}

#[test]
fn tga_of_unknown_kinds_is_refused() {
    for kind in [0, 4, 8, 32, 163] {
        let file = made::tga(kind, (0, 0, 0), (1, 1), 8, 0, &[1; 9]);
        let said = refused(&file, TextureLimits::default()).to_string();
        assert!(said == "the TGA picture is of a kind that is not read", "{said}");
    }
}

#[test]
fn bmp_has_many_kinds_of_pixels() {
    let pixels = |bits, width, palette: &[u8], body: &[u8]| {
        rgba8(&read(&made::bmp(bits, (width, 1), palette, body)).unwrap())
    };
    let row = [1, 2, 3, 4, 5, 6, 0, 0];
    assert_eq!(pixels(24, 2, &[], &row), [[3, 2, 1, 255], [6, 5, 4, 255]]);
    let mut palette = [0; 1024];
    palette[4 * 200..][..3].copy_from_slice(&[7, 8, 9]);
    assert_eq!(pixels(8, 1, &palette, &[200, 0, 0, 0]), [[9, 8, 7, 255]]);
    assert_eq!(pixels(32, 2, &[], &[1, 2, 3, 4, 5, 6, 7, 0]), [[3, 2, 1, 4], [7, 6, 5, 0]]);
    // A place for opacity that nobody filled.
    assert_eq!(pixels(32, 2, &[], &[1, 2, 3, 0, 5, 6, 7, 0]), [[3, 2, 1, 255], [7, 6, 5, 255]]);
    // From the bottom.
    let rows = made::bmp(24, (1, 2), &[], &[1, 1, 1, 0, 2, 2, 2, 0]);
    assert_eq!(rgba8(&read(&rows).unwrap()), [[2, 2, 2, 255], [1, 1, 1, 255]]);
}

#[test]
fn tga_may_say_that_its_fourth_byte_is_no_opacity() {
    let opacity = |kind: u8| {
        let mut file = made::tga(2, (0, 0, 0), (1, 1), 32, 0x28, &[1, 2, 3, 0]);
        let area = file.len() as u32;
        file.extend(495_u16.to_le_bytes());
        file.resize(area as usize + 494, 0);
        file.push(kind);
        file.extend([area, 0].iter().flat_map(|offset| offset.to_le_bytes()));
        file.extend(b"TRUEVISION-XFILE.\0");
        let found = read(&file).unwrap();
        (rgba8(&found)[0][3], found.alpha_is_undefined)
    };
    let expected = [(255, false), (255, false), (0, true), (0, false), (0, false)];
    assert_eq!([0, 1, 2, 3, 4].map(opacity), expected);
}

/// The colour i of the headers of [`made::pcx`].
fn of_header(i: u8) -> [u8; 4] {
    [5 * i, 10 * i, 15 * i, 255]
}

#[test]
fn pcx_has_many_kinds_of_pixels() {
    let pixels = |bits, planes, width, row, body: &[u8]| {
        let found = read(&made::pcx(bits, planes, (width, 1), row, body)).unwrap();
        assert_eq!(found.warnings, []);
        rgba8(&found)
    };
    let (black, white) = ([0, 0, 0, 255], [255; 4]);
    assert_eq!(pixels(1, 1, 3, 2, &[0b1010_0000, 0]), [white, black, white]);
    let nine = [white, black, black, black, black, black, black, black, white];
    assert_eq!(pixels(1, 1, 9, 2, &[0b1000_0000, 0b1000_0000]), nine);
    assert_eq!(pixels(4, 1, 3, 2, &[0x1f, 0x70]), [1, 15, 7].map(of_header));
    assert_eq!(pixels(2, 1, 3, 2, &[0b0111_1000, 0]), [1, 3, 2].map(of_header));
    let planes = [0b1100_0000, 0, 0b0100_0000, 0, 0, 0, 0b0010_0000, 0];
    assert_eq!(pixels(1, 4, 3, 2, &planes), [1, 3, 8].map(of_header));
    assert_eq!(pixels(8, 3, 1, 2, &[1, 0, 2, 0, 3, 0]), [[1, 2, 3, 255]]);
    // An odd number of bytes, and none behind the last row.
    assert_eq!(pixels(8, 3, 1, 3, &[1, 0, 0, 2, 0, 0, 3]), [[1, 2, 3, 255]]);
    let mut palette = [0; 769];
    (palette[0], palette[1 + 3 * 200 + 1]) = (0x0c, 77);
    let body = [&[200, 0][..], &palette].concat();
    assert_eq!(pixels(8, 1, 1, 2, &body), [[0, 77, 0, 255]]);
}

/// Runs may go on over planes and rows. Rows begin every so many bytes as the header says,
/// also where a width needs fewer: Pillow 13.0.0 takes what fills them for pixels, where
/// pygame 2.6.1 shifts the colours of odd widths.
#[test]
fn pcx_rows_are_where_the_header_says() {
    let packed = |row, body: &[u8]| {
        let mut file = made::pcx(8, 3, (1, 2), row, body);
        file[2] = 1;
        rgba8(&read(&file).unwrap())
    };
    assert_eq!(packed(1, &[0xc6, 77]), [[77, 77, 77, 255]; 2]);
    assert_eq!(packed(1, &[1, 2, 0xc3, 9, 4]), [[1, 2, 9, 255], [9, 9, 4, 255]]);
    let filled: Vec<u8> = (1..7).flat_map(|plane| [plane, 0xc3, 0]).collect();
    assert_eq!(packed(4, &filled), [[1, 2, 3, 255], [4, 5, 6, 255]]);
}

/// The warnings, and the pixels.
fn repaired(bytes: &[u8]) -> (Vec<String>, Vec<[u8; 4]>) {
    let found = read(bytes).unwrap();
    (found.warnings.iter().map(ToString::to_string).collect(), rgba8(&found))
}

#[test]
fn what_is_repaired_is_told() {
    let short = made::pcx(8, 3, (1, 3), 1, &[1, 2, 3, 4, 5]);
    let (said, pixels) = repaired(&short);
    assert_eq!(said, ["a: cut off, rows at the bottom are missing"]);
    assert_eq!(pixels, [[1, 2, 3, 255], [0, 0, 0, 255], [0, 0, 0, 255]]);
    let (said, pixels) = repaired(&made::pcx(8, 1, (2, 1), 2, &[7, 9]));
    assert_eq!(said, ["a: no palette, its colours are taken for greys"]);
    assert_eq!(pixels, [[7, 7, 7, 255], [9, 9, 9, 255]]);
    let (_, jpeg) = made::all(16, 16).swap_remove(1);
    assert_eq!(read(&jpeg).unwrap().warnings, []);
    let (said, _) = repaired(&jpeg[..jpeg.len() - 2]);
    assert_eq!(said, ["a: cut off, the end of the picture is missing"]);
}

#[test]
fn light_is_linear_and_opacity_is_as_stored() {
    let mut file = Vec::new();
    let pixels: Vec<u8> =
        [65_535_u16, 0, 32_768, 16_384].iter().flat_map(|n| n.to_ne_bytes()).collect();
    PngEncoder::new(&mut file).write_image(&pixels, 1, 1, ExtendedColorType::Rgba16).unwrap();
    let found = read(&file).unwrap();
    let light = *found.pixels.get(0, 0);
    assert_eq!((light.r, light.g), (1.0, 0.0));
    assert!((light.b - 0.214_05).abs() < 1e-5, "{light:?}");
    assert!((found.alpha.unwrap().get(0, 0) - 0.25).abs() < 1e-5);
    // 16 bits are not taken for 8.
    assert!(light.b != crate::srgb::decode(128.0 / 255.0));
}

/// Every byte that a PNG of one grey row has comes back, through the curve and back.
#[test]
fn all_bytes_come_back() {
    let mut file = Vec::new();
    let bytes: Vec<u8> = (0..=255).collect();
    PngEncoder::new(&mut file).write_image(&bytes, 256, 1, ExtendedColorType::L8).unwrap();
    let expected: Vec<_> = bytes.iter().map(|&n| [n, n, n, 255]).collect();
    assert_eq!(rgba8(&read(&file).unwrap()), expected);
}

#[test]
fn what_is_written_is_read() {
    let folder = crate::picture::tests::Folder::new("written");
    let value = |i: usize| Rgb::new(i as f32 / 85.0, 1.0 / (i + 1) as f32, 0.25);
    for width in [1, 3, 5, 17] {
        let light = Grid::from_values(width, 5, (0..5 * width).map(value).collect()).unwrap();
        let screen: Vec<_> = light.values().iter().map(|&light| screen_rgb(light, 1.0)).collect();
        for format in ["png", "tga", "pcx", "exr", "hdr"] {
            let path = folder.path().join(format!("a.{format}"));
            crate::write_picture(&path, &light, 1.0, &[]).unwrap();
            let found = load_texture(&path, TextureLimits::default()).unwrap();
            let size = (found.pixels.width(), found.pixels.height());
            assert_eq!((size, &found.alpha, found.warnings.len()), ((width, 5), &None, 0));
            match format {
                "exr" => assert_eq!(found.pixels, light),
                "hdr" => assert!(far(&found.pixels, &light) <= 1.0 / 256.0),
                _ => assert!(rgba8(&found).iter().zip(&screen).all(|(a, b)| a[..3] == b[..])),
            }
        }
    }
}

/// The largest difference of a band, where no band is above one.
fn far(a: &Grid<Rgb>, b: &Grid<Rgb>) -> f32 {
    let pairs = a.values().iter().zip(b.values());
    pairs.fold(0.0, |most, (&a, &b)| {
        (a.to_array().into_iter().zip(b.to_array()))
            .fold(most, |most, (a, b)| most.max((a - b).abs()))
    })
}
