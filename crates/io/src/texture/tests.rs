use super::*;
use crate::picture::screen_rgb;

mod formats;
mod hostile;
mod made;

/// The bytes that a texture was stored as, if it had 8 bits a channel.
fn rgba8(texture: &Texture) -> Vec<[u8; 4]> {
    let alpha = |index| texture.alpha.as_ref().map_or(1.0, |alpha| alpha.values()[index]);
    let pixel = |(index, &light)| {
        let [r, g, b] = screen_rgb(light, 1.0);
        [r, g, b, (alpha(index) * 255.0_f32).round() as u8]
    };
    texture.pixels.values().iter().enumerate().map(pixel).collect()
}

fn read(bytes: &[u8]) -> Result<Texture, Error> {
    texture_from_bytes(bytes, Path::new("a"), TextureLimits::default())
}

/// Returns the error by which bytes are refused.
#[track_caller]
fn refused(bytes: &[u8], limits: TextureLimits) -> TextureError {
    match texture_from_bytes(bytes, Path::new("a.tga"), limits) {
        Err(Error::ReadPicture { cause, .. }) => *cause.downcast::<TextureError>().unwrap(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn sizes_are_bounded_before_memory_is_taken() {
    let small = TextureLimits { pixels: 11, file_bytes: 100_000 };
    for (format, bytes) in made::all(4, 3) {
        let said = refused(&bytes, small).to_string();
        assert_eq!(said, "4x3 pixels are more than the 11 allowed", "{format}");
        let enough = TextureLimits { pixels: 12, ..small };
        let read = texture_from_bytes(&bytes, Path::new("a.tga"), enough);
        assert_eq!(read.unwrap().pixels.values().len(), 12, "{format}");
    }
    // 65535 × 65535 pixels in a few bytes.
    let huge = made::tga(2, (0, 0, 0), (u16::MAX, u16::MAX), 24, 0, &[]);
    let said = refused(&huge, TextureLimits::default()).to_string();
    assert_eq!(said, "65535x65535 pixels are more than the 8388608 allowed");
}

#[test]
fn files_are_bounded_too() {
    let folder = crate::picture::tests::Folder::new("long");
    let path = folder.path().join("a.gif");
    std::fs::write(&path, made::gif(3, 3, false)).unwrap();
    let length = std::fs::metadata(&path).unwrap().len();
    let limits = |file_bytes| TextureLimits { file_bytes, ..TextureLimits::default() };
    assert!(load_texture(&path, limits(length)).is_ok());
    let said = load_texture(&path, limits(length - 1)).unwrap_err().to_string();
    let expected = format!("cannot be read as a picture: it has more than {} bytes", length - 1);
    assert!(said.ends_with(&expected), "{said}");
    let missing = load_texture(Path::new("no/such.gif"), limits(0));
    assert!(matches!(missing, Err(Error::ReadPicture { .. })), "{missing:?}");
}

#[test]
fn what_is_of_no_format_says_what_is() {
    let said = texture_from_bytes(b"P3 1 1", Path::new("a.ppm"), TextureLimits::default());
    let said = said.unwrap_err().to_string();
    assert!(said.starts_with("a.ppm: cannot be read as a picture: it begins as none of"), "{said}");
}

#[test]
fn exr_files_are_read_from_disk() {
    let folder = crate::picture::tests::Folder::new("texture-exr");
    // By content, not by name.
    let (path, named) = (folder.path().join("a.exr"), folder.path().join("a.gif"));
    let light = Grid::filled(3, 1, Rgb::new(7.0, -1.0, 0.1));
    crate::write_picture(&path, &light, 1.0, &[]).unwrap();
    std::fs::rename(&path, &named).unwrap();
    let expected = Texture {
        pixels: light,
        alpha: None,
        alpha_is_undefined: false,
        coding: Coding::Linear,
        warnings: Vec::new(),
    };
    assert_eq!(load_texture(&named, TextureLimits::default()).unwrap(), expected);
}

/// Memory is checked whatever is allowed: an allocation that fails ends the program.
#[test]
fn what_memory_does_not_hold_is_refused() {
    let limits = TextureLimits { pixels: u64::MAX, ..TextureLimits::default() };
    assert!(matches!(limits.check(u32::MAX, u32::MAX), Err(TextureError::Memory(_))));
    assert!(limits.check(64, 64).is_ok());
}
