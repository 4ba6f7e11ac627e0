//! Pictures by the hash of their pixels.

use crate::sha256::sha256;
use serde_json::Value;
use std::path::Path;
use traylib_io::picture::screen_rgb;
use traylib_io::{Error, Texture, TextureLimits, load_texture};

type Pixels = Vec<[u8; 4]>;

/// A change of pixels before they are held against a hash.
type Adjust = fn(Pixels) -> Pixels;

/// The files on which other readers disagree with one another or with ours for a reason: the file,
/// the change of its pixels, the file whose hash they then have.
const OTHERWISE: [(&str, Adjust, &str); 5] = [
    ("gif/gd_small_frame_big_canvas.gif", with_background, "gif/gd_small_frame_big_canvas.gif"),
    ("tga/b5-attrib.tga", cut_to_five_bits, "tga/b5-noattrib.tga"),
    ("tga/b5-cmap.tga", cut_to_five_bits, "tga/b5-cmap.tga"),
    ("tga/b5-noattrib.tga", cut_to_five_bits, "tga/b5-noattrib.tga"),
    ("tga/utc16.tga", cut_to_five_bits, "tga/utc16.tga"),
];

/// The file of which others agree on which pixels are transparent, not on their colour.
const BY_COVER: &str = "gif/pil_first_frame_transparency.gif";

/// Read by others, refused here: without colours there is nothing to show.
const REFUSED: &str = "gif/pil_no_palette.gif";

/// Describes the difference of a file from what is expected, by its name in the list; `None`
/// without one.
pub(super) fn complaint(folder: &Path, list: &Value, name: &str) -> Option<String> {
    let (expected, found) =
        (&list[name], load_texture(&folder.join(name), TextureLimits::default()));
    let refused = expected["rgba8_sha256"].is_null() || name == REFUSED;
    match (found, refused) {
        (Err(Error::ReadPicture { .. }), true) => None,
        (Ok(_), true) => Some("no error, expected one".to_string()),
        (Err(error), _) => Some(error.to_string()),
        (Ok(found), false) => differs(list, name, &found),
    }
}

fn differs(list: &Value, name: &str, found: &Texture) -> Option<String> {
    let pixels = rgba8(found);
    if name == BY_COVER {
        let visible: Pixels = pixels.iter().copied().filter(|pixel| pixel[3] > 0).collect();
        let green = visible.len() == 1250 && visible.iter().all(|pixel| *pixel == [0, 255, 0, 255]);
        return (pixels.len() != 3750 || !green).then(|| "other pixels are visible".to_string());
    }
    let width = list[name]["width"].as_u64().unwrap_or(found.pixels.width() as u64);
    if found.pixels.width() as u64 != width || !found.warnings.is_empty() {
        return Some(format!("{} columns, {:?}", found.pixels.width(), found.warnings));
    }
    let otherwise = OTHERWISE.iter().find(|(file, ..)| *file == name);
    let (pixels, like) =
        otherwise.map_or((pixels.clone(), name), |(_, adjust, like)| (adjust(pixels), *like));
    let (hash, expected) = (sha256(pixels.as_flattened()), &list[like]["rgba8_sha256"]);
    (*expected != hash).then(|| format!("pixels of hash {hash}, expected {expected}"))
}

/// The bytes that a picture was stored as, if it had 8 bits a channel.
fn rgba8(picture: &Texture) -> Pixels {
    let alpha = |index| picture.alpha.as_ref().map_or(1.0, |alpha| alpha.values()[index]);
    let pixel = |(index, &light)| {
        let [r, g, b] = screen_rgb(light, 1.0);
        [r, g, b, (alpha(index) * 255.0_f32).round() as u8]
    };
    picture.pixels.values().iter().enumerate().map(pixel).collect()
}

/// The uncovered part of the screen is transparent here, and has the background's
/// colour with others.
fn with_background(pixels: Pixels) -> Pixels {
    let shown = |pixel: [u8; 4]| if pixel[3] == 0 { [200, 200, 200, 255] } else { pixel };
    pixels.into_iter().map(shown).collect()
}

/// Five bits become the nearest eight here; others cut off. The sixteenth is opacity to
/// some.
fn cut_to_five_bits(pixels: Pixels) -> Pixels {
    let cut = |byte: u8| (((u32::from(byte) * 31 + 127) / 255) * 255 / 31) as u8;
    pixels.into_iter().map(|pixel| pixel.map(cut)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn five_bits_are_cut_off_and_nothing_else_is_changed() {
        assert_eq!(cut_to_five_bits(vec![[255, 0, 132, 255]]), [[255, 0, 131, 255]]);
        assert_eq!(
            with_background(vec![[1, 2, 3, 4], [0; 4]]),
            [[1, 2, 3, 4], [200, 200, 200, 255]]
        );
    }

    #[test]
    fn a_file_that_is_not_there_is_complained_of() {
        let list = serde_json::json!({"a.gif": {"rgba8_sha256": "00"}});
        assert!(complaint(Path::new("no-such-folder"), &list, "a.gif").is_some());
    }
}
