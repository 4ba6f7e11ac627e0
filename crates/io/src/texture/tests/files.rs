//! Files of other programs, where there are any: in the folder that the variable
//! TRAYLIB_DATA names, with the pixels that two other readers find in them.

use super::sha256::sha256;
use super::*;
use serde_json::Value;
use std::path::PathBuf;

fn folder(name: &str) -> Option<PathBuf> {
    let data = std::env::var_os("TRAYLIB_DATA");
    if data.is_none() {
        println!("skipped: TRAYLIB_DATA names no folder with real files");
    }
    data.map(|data| PathBuf::from(data).join(name))
}

/// Files of a folder with what is to be found in each.
fn expected(folder: &Path) -> Vec<(String, Value)> {
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let mut all: Value = serde_json::from_str(&text).unwrap();
    let Value::Object(files) = all["files"].take() else { panic!("no files") };
    files.into_iter().collect()
}

fn load(path: &Path) -> Result<Texture, Error> {
    load_texture(path, TextureLimits::default())
}

fn hash(pixels: &[[u8; 4]]) -> String {
    sha256(pixels.as_flattened())
}

/// Where readers disagree, or say nothing of a file that is whole, it has a test of
/// its own.
const APART: [&str; 7] = [
    "gif/gd_small_frame_big_canvas.gif",
    "gif/pil_first_frame_transparency.gif",
    "gif/pil_no_palette.gif",
    "tga/b5-attrib.tga",
    "tga/b5-cmap.tga",
    "tga/b5-noattrib.tga",
    "tga/utc16.tga",
];

fn check(name: &str, least: usize) {
    let Some(folder) = folder(name) else { return };
    let mut checked = 0;
    for (file, value) in expected(&folder) {
        if APART.contains(&file.as_str()) {
            continue;
        }
        let found = load(&folder.join(&file));
        checked += 1;
        let Some(pixels) = value["rgba8_sha256"].as_str() else {
            assert!(matches!(found, Err(Error::ReadPicture { .. })), "{file}: {found:?}");
            continue;
        };
        let found = found.unwrap();
        assert_eq!(found.warnings, [], "{file}");
        if let Some(width) = value["width"].as_u64() {
            assert_eq!(found.pixels.width() as u64, width, "{file}");
        }
        assert_eq!(hash(&rgba8(&found)), pixels, "{file}");
    }
    assert!(checked >= least, "{checked}");
}

#[test]
fn textures_have_the_pixels_that_others_find() {
    check("textures", 40);
}

#[test]
fn pictures_have_the_pixels_that_others_find() {
    check("pictures", 12);
}

/// The uncovered part of the screen is transparent here, and has the background's
/// colour with others.
#[test]
fn a_small_frame_on_a_large_screen() {
    let Some(folder) = folder("textures") else { return };
    let file = "gif/gd_small_frame_big_canvas.gif";
    let mut pixels = rgba8(&load(&folder.join(file)).unwrap());
    let none = pixels.iter().filter(|pixel| **pixel == [0; 4]).count();
    assert_eq!((pixels.len(), none), (16 * 16, 16 * 16 - 4 * 4));
    for pixel in pixels.iter_mut().filter(|pixel| pixel[3] == 0) {
        *pixel = [200, 200, 200, 255];
    }
    let expected = expected(&folder).into_iter().find(|(name, _)| name == file).unwrap().1;
    assert_eq!(hash(&pixels), expected["rgba8_sha256"]);
}

/// Others agree on which pixels are transparent, not on their colour.
#[test]
fn a_first_frame_with_transparent_pixels() {
    let Some(folder) = folder("textures") else { return };
    let found = load(&folder.join("gif/pil_first_frame_transparency.gif")).unwrap();
    let pixels = rgba8(&found);
    let visible: Vec<_> = pixels.iter().filter(|pixel| pixel[3] > 0).collect();
    assert!(visible.iter().all(|pixel| **pixel == [0, 255, 0, 255]));
    assert_eq!((pixels.len(), visible.len()), (3750, 1250));
}

#[test]
fn a_picture_without_colours_is_refused() {
    let Some(folder) = folder("textures") else { return };
    let said = load(&folder.join("gif/pil_no_palette.gif")).unwrap_err().to_string();
    assert!(said.contains("as a picture: GIF: ") && !said.contains('\n'), "{said}");
}

/// Five bits become the nearest eight; others cut off. The sixteenth is opacity to
/// some.
#[test]
fn sixteen_bits_are_what_others_find_but_for_rounding() {
    let Some(folder) = folder("textures") else { return };
    let cut = |byte: u8| (((u32::from(byte) * 31 + 127) / 255) * 255 / 31) as u8;
    let expected = expected(&folder);
    for (file, like) in [
        ("tga/b5-attrib.tga", "tga/b5-noattrib.tga"),
        ("tga/b5-cmap.tga", "tga/b5-cmap.tga"),
        ("tga/b5-noattrib.tga", "tga/b5-noattrib.tga"),
        ("tga/utc16.tga", "tga/utc16.tga"),
    ] {
        let found = load(&folder.join(file)).unwrap();
        let pixels: Vec<_> = rgba8(&found).into_iter().map(|pixel| pixel.map(cut)).collect();
        let (_, value) = expected.iter().find(|(name, _)| name == like).unwrap();
        assert_eq!(hash(&pixels), value["rgba8_sha256"], "{file}");
    }
}
