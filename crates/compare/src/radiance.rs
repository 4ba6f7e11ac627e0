//! Pictures that were given: light in numbers, of whichever program.

use std::path::Path;
use traylib_demos::{Failure, say};
use traylib_io::{Coding, MAX_PIXELS, TextureLimits, load_texture, open_exr};
use traylib_math::{Grid, Rgb};

/// The limits with which `film` reads pictures, too.
const LIMITS: TextureLimits = TextureLimits { pixels: MAX_PIXELS, file_bytes: 1 << 32 };

/// The radiance of a picture, EXR or Radiance; tells what was repaired.
///
/// # Errors
/// It cannot be read, or its numbers are those of a screen.
pub fn load(path: &Path) -> Result<Grid<Rgb>, Failure> {
    let picture = load_texture(path, LIMITS)?;
    if picture.coding == Coding::Srgb {
        return Err(Failure::scene(format_args!(
            "{}: holds the colours of a screen, cut off at white, where radiance is compared; \
             wanted: an EXR or Radiance picture of the same render",
            path.display()
        )));
    }
    for warning in &picture.warnings {
        say(format_args!("warning: {warning}"));
    }
    Ok(picture.pixels)
}

/// Returns what stands against comparing a picture with a scene: that it says of itself that it
/// shows another. Only EXR pictures say anything.
pub fn another_scene(path: &Path, scene: &str) -> Option<String> {
    let layers = open_exr(path).ok()?.layers;
    let mut texts = layers.into_iter().flat_map(|layer| layer.attributes);
    let (_, shown) = texts.find(|(name, shown)| name == "scene" && shown != scene)?;
    Some(format!("{}: says that it shows `{shown}`, not `{scene}`", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_io::{PictureInfo, Tone, save_picture};

    fn info(scene: &str) -> PictureInfo {
        PictureInfo {
            exposure: 1.0,
            tone: Tone::Linear,
            program: String::new(),
            integrator: String::new(),
            command: String::new(),
            scene: scene.into(),
            seed: 0,
            spp: 1,
            rejected_samples: 0,
            frame: None,
        }
    }

    #[test]
    fn light_is_read_and_colours_of_a_screen_are_refused() {
        let folder = std::env::temp_dir().join(format!("traylib-light-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let light = Grid::filled(8, 4, Rgb::splat(2.0));
        for (name, fit) in [("a.exr", true), ("a.hdr", true), ("a.png", false), ("a.tga", false)] {
            let file = folder.join(name);
            save_picture(&file, &light, &info("cornell")).unwrap();
            match load(&file) {
                Ok(read) => assert!(fit && read == light, "{name}"),
                Err(error) => {
                    let text = error.to_string();
                    assert!(!fit && text.contains("colours of a screen"), "{text}");
                }
            }
            let against = another_scene(&file, "pyramid");
            assert_eq!(against.is_some(), name == "a.exr", "{against:?}");
            assert_eq!(another_scene(&file, "cornell"), None);
        }
        std::fs::remove_dir_all(folder).unwrap();
    }
}
