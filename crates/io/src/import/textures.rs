//! Pictures on surfaces: read once for each way in which they are used.

use crate::source::Location;
use crate::texture::{self, Coding, TextureLimits, load_texture, texture_from_bytes};
use crate::{Error, Limit, ReadLimits, TextureError, Warning, srgb};
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;
use traylib_materials::{Layer, Texture};
use traylib_math::{Grid, Rgb};

/// The meaning of a picture's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Meaning {
    /// Light, to be made linear.
    Colour,
    /// Opacity or height: the numbers as stored, which the curve for screens has
    /// nothing to do with.
    Amount,
    /// The picture's own opacity.
    Alpha,
    /// The picture's own opacity, of which all is there where it is at least the number of these
    /// bits, and nothing elsewhere.
    Mask(u32),
}

/// The use that is made of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Usage {
    pub(super) meaning: Meaning,
    /// Whether black and white are exchanged.
    pub(super) negative: bool,
    /// The factor of every value.
    pub(super) factor: Rgb,
}

impl Usage {
    /// The picture as it is.
    pub(super) fn plain(meaning: Meaning) -> Self {
        Self { meaning, negative: false, factor: Rgb::WHITE }
    }
}

/// Pixels that all pictures may have together, 1.5 GiB.
const MOST_PIXELS: u64 = 1 << 27;

/// Zero instead of what is infinite or not a number, and how often. Whatever a picture is
/// used for, such a number would make light that is none.
fn sound(mut pixels: Grid<Rgb>) -> (Grid<Rgb>, u32) {
    let mut count = 0_u32;
    for pixel in pixels.values_mut() {
        *pixel = Rgb::from(pixel.to_array().map(|band| {
            count = count.saturating_add(u32::from(!band.is_finite()));
            if band.is_finite() { band } else { 0.0 }
        }));
    }
    (pixels, count)
}

/// One, but for the rounding of the curve for screens, there and back.
const FULL: f32 = 1.0 - 1e-6;

/// Why a picture cannot be used, and which limit would let it in.
fn described(error: &Error) -> String {
    let Error::ReadPicture { cause, .. } = error else { return error.to_string() };
    match cause.downcast_ref() {
        Some(TextureError::TooLarge { most, .. }) => {
            format!("{error}; {}", Limit::Pixels.remedy(*most))
        }
        Some(TextureError::TooLong(most)) => format!("{error}; {}", Limit::Bytes.remedy(*most)),
        _ => error.to_string(),
    }
}

/// The source of a picture.
pub(super) enum PictureSource<'a> {
    /// A file.
    File(&'a Location),
    /// Bytes of one within another file.
    Bytes {
        /// Its name.
        name: String,
        /// All of it.
        bytes: &'a [u8],
    },
}

impl PictureSource<'_> {
    fn name(&self) -> String {
        match self {
            Self::File(location) => location.to_string(),
            Self::Bytes { name, .. } => name.clone(),
        }
    }

    fn picture(&self, limits: TextureLimits) -> Result<texture::Texture, String> {
        let picture = match self {
            Self::File(Location::Disk(path)) => load_texture(path, limits),
            Self::File(file @ Location::BuiltIn(name)) => {
                let bytes = file.read().map_err(|cause| format!("{file}: {cause}"))?;
                texture_from_bytes(&bytes, Path::new(name), limits)
            }
            Self::Bytes { name, bytes } => texture_from_bytes(bytes, Path::new(name), limits),
        };
        picture.map_err(|error| described(&error))
    }
}

type Key = (String, Meaning, bool, [u32; 3]);

/// The pictures read so far.
#[derive(Default)]
pub(super) struct Textures {
    known: HashMap<Key, Result<Arc<Texture>, String>>,
    /// Pixels of all pictures so far.
    pixels: u64,
    limits: TextureLimits,
    /// The pictures with no band of any pixel below one.
    full: Vec<Arc<Texture>>,
    warnings: Vec<Warning>,
}

impl Textures {
    pub(super) fn new(limits: ReadLimits) -> Self {
        Self { limits: limits.texture(), ..Self::default() }
    }

    /// Loads a picture, or says why it cannot be used.
    pub(super) fn load(&mut self, file: &Location, usage: Usage) -> Result<Arc<Texture>, String> {
        self.load_from(&PictureSource::File(file), usage)
    }

    /// [`load`](Self::load) from anywhere. Pictures of the same name are the same.
    pub(super) fn load_from(
        &mut self,
        source: &PictureSource<'_>,
        usage: Usage,
    ) -> Result<Arc<Texture>, String> {
        let Usage { meaning, negative, factor } = usage;
        let key = (source.name(), meaning, negative, factor.to_array().map(f32::to_bits));
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let texture = self.read(source, usage);
        self.known.insert(key, texture.clone());
        texture
    }

    /// Loads a picture that emits light, times this factor. There is no light below zero: what
    /// is negative is none.
    pub(super) fn load_light(&mut self, file: &Location, factor: f32) -> Result<Grid<Rgb>, String> {
        let factor = Rgb::splat(factor);
        let usage = Usage { factor, ..Usage::plain(Meaning::Colour) };
        let mut light = self.pixels_of(&PictureSource::File(file), usage)?;
        let mut count = 0_u32;
        for pixel in light.values_mut().iter_mut().filter(|pixel| pixel.min_band() < 0.0) {
            *pixel = Rgb::from(pixel.to_array().map(|band| band.max(0.0)));
            count = count.saturating_add(1);
        }
        if count > 0 {
            let what = "negative light taken for 0".to_string();
            self.warnings.push(Warning { file: file.to_string(), what, count });
        }
        Ok(light)
    }

    fn read(&mut self, source: &PictureSource<'_>, usage: Usage) -> Result<Arc<Texture>, String> {
        let pixels = self.pixels_of(source, usage)?;
        let is_full = pixels.values().iter().all(|pixel| pixel.min_band() >= FULL);
        let texture =
            Texture::new(pixels).ok_or_else(|| format!("{}: it has no pixels", source.name()))?;
        let texture = Arc::new(texture);
        if is_full {
            self.full.push(Arc::clone(&texture));
        }
        Ok(texture)
    }

    /// The pixels of a picture as they are used, all of them numbers.
    fn pixels_of(&mut self, source: &PictureSource<'_>, usage: Usage) -> Result<Grid<Rgb>, String> {
        let file = source.name();
        let most = MOST_PIXELS.max(self.limits.pixels);
        let left = self.limits.pixels.min(most - self.pixels);
        let limits = TextureLimits { pixels: left, ..self.limits };
        let picture = source.picture(limits)?;
        self.pixels = most.min(self.pixels + picture.pixels.values().len() as u64);
        let (pixels, none) = sound(pixels(&picture, usage));
        let repaired = (none > 0).then(|| Warning {
            file: file.clone(),
            what: "number that is infinite or none taken for 0".to_string(),
            count: none,
        });
        for warning in picture.warnings.into_iter().chain(repaired) {
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
        Ok(pixels)
    }

    /// Returns a layer of opacity, unless its picture leaves nothing out.
    pub(super) fn opacity(&self, layer: Layer) -> Option<Layer> {
        let is_full = self.full.iter().any(|full| Arc::ptr_eq(full, &layer.texture));
        (!is_full).then_some(layer)
    }

    /// Returns what was repaired.
    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.warnings
    }
}

fn pixels(picture: &texture::Texture, usage: Usage) -> Grid<Rgb> {
    let is_coded = match picture.coding {
        Coding::Linear => false,
        Coding::Srgb => true,
    };
    let bands = |pixel: Rgb, f: fn(f32) -> f32| Rgb::from(pixel.to_array().map(f));
    let stored = |pixel: &Rgb| if is_coded { bands(*pixel, srgb::encode) } else { *pixel };
    let turned = |pixel: Rgb| if usage.negative { bands(pixel, |x| 1.0 - x) } else { pixel };
    let alpha = picture.alpha.as_ref().filter(|_| !picture.alpha_is_undefined);
    match (usage.meaning, alpha) {
        (Meaning::Colour, _) if !usage.negative => picture.pixels.map(|&p| p * usage.factor),
        (Meaning::Colour, _) => picture.pixels.map(|pixel| {
            let negative = turned(stored(pixel));
            (if is_coded { bands(negative, srgb::decode) } else { negative }) * usage.factor
        }),
        (Meaning::Amount, _) => picture.pixels.map(|p| turned(stored(p)) * usage.factor),
        (Meaning::Alpha, Some(alpha)) => alpha.map(|&a| turned(Rgb::splat(a)) * usage.factor),
        (Meaning::Mask(bits), alpha) => {
            let is_there = |a: f32| usage.factor.g * a >= f32::from_bits(bits);
            let shown = |a: f32| if is_there(a) { Rgb::WHITE } else { Rgb::BLACK };
            match alpha {
                Some(alpha) => alpha.map(|&a| shown(a)),
                None => picture.pixels.map(|_| shown(1.0)),
            }
        }
        (Meaning::Alpha, None) => picture.pixels.map(|_| turned(Rgb::WHITE) * usage.factor),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::tests::Folder;
    use crate::write_picture;
    use std::fs;
    use traylib_materials::Tiling;
    use traylib_math::Vec2;

    /// Loads a picture and returns the value in its middle.
    fn loaded(file: &Path, meaning: Meaning) -> f32 {
        let location = Location::Disk(file.to_path_buf());
        let texture = Textures::default().load(&location, Usage::plain(meaning)).unwrap();
        texture.lookup(Vec2::splat(0.5), Tiling::Repeat).unwrap().g
    }

    /// A name says nothing, whatever the picture is used for.
    #[test]
    fn content_decides_whether_numbers_are_light() {
        let folder = Folder::new("coding");
        let grey = Grid::filled(2, 2, Rgb::splat(0.25));
        let [amount, colour] = [Meaning::Amount, Meaning::Colour];
        for (format, as_stored) in
            [("hdr", 0.25), ("exr", 0.25), ("png", 137.0 / 255.0), ("tga", 137.0 / 255.0)]
        {
            let written = folder.path().join(format!("a.{format}"));
            for name in ["b.pic", "b.hdr", "b.exr", "b.png", "b.tga", "b"] {
                write_picture(&written, &grey, 1.0, &[]).unwrap();
                let renamed = folder.path().join(name);
                fs::rename(&written, &renamed).unwrap();
                let found = [loaded(&renamed, amount), loaded(&renamed, colour)];
                assert!((found[0] - as_stored).abs() < 1e-6, "{format} {name}: {found:?}");
                assert!((found[1] - 0.25).abs() < 2e-3, "{format} {name}: {found:?}");
            }
        }
    }

    #[test]
    fn undefined_opacity_is_none() {
        let picture = |alpha_is_undefined| texture::Texture {
            pixels: Grid::filled(1, 1, Rgb::BLACK),
            alpha: Some(Grid::filled(1, 1, 0.25)),
            alpha_is_undefined,
            coding: Coding::Srgb,
            warnings: Vec::new(),
        };
        let opacity = |picture| pixels(&picture, Usage::plain(Meaning::Alpha)).values()[0].g;
        assert_eq!([false, true].map(|undefined| opacity(picture(undefined))), [0.25, 1.0]);
    }

    /// They are zero for any use, with one warning for the file.
    #[test]
    fn numbers_that_are_none_are_zero() {
        let folder = Folder::new("none");
        let path = folder.path().join("a.exr");
        let pixels = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.5].map(Rgb::splat);
        let grid = Grid::from_values(2, 2, pixels.to_vec()).unwrap();
        write_picture(&path, &grid, 1.0, &[]).unwrap();
        let mut textures = Textures::default();
        for (meaning, negative) in
            [(Meaning::Colour, false), (Meaning::Amount, false), (Meaning::Colour, true)]
        {
            let usage = Usage { meaning, negative, factor: Rgb::WHITE };
            let texture = textures.load(&Location::Disk(path.clone()), usage).unwrap();
            let found = [[0.25, 0.75], [0.75, 0.75], [0.25, 0.25], [0.75, 0.25]]
                .map(|uv| texture.lookup(Vec2::from(uv), Tiling::Repeat).unwrap().g);
            assert_eq!(found, [0.0, 0.0, 0.0, 0.5], "{meaning:?}");
        }
        let said: Vec<String> = textures.into_warnings().iter().map(Warning::to_string).collect();
        let expected = "a.exr: number that is infinite or none taken for 0 (9 times)";
        assert!(said.len() == 1 && said[0].ends_with(expected), "{said:?}");
    }

    fn value(meaning: Meaning, negative: bool, factor: f32, coding: Coding) -> f32 {
        let grey = srgb::decode(0.25);
        let picture = texture::Texture {
            pixels: Grid::filled(1, 1, Rgb::splat(grey)),
            alpha: Some(Grid::filled(1, 1, 0.75)),
            alpha_is_undefined: false,
            coding,
            warnings: Vec::new(),
        };
        pixels(&picture, Usage { meaning, negative, factor: Rgb::splat(factor) }).values()[0].g
    }

    #[test]
    fn amounts_are_as_stored_and_colours_linear() {
        let near = |a: f32, b: f32| assert!((a - b).abs() < 1e-6, "{a} {b}");
        near(value(Meaning::Colour, false, 0.5, Coding::Srgb), 0.5 * srgb::decode(0.25));
        near(value(Meaning::Amount, false, 1.0, Coding::Srgb), 0.25);
        near(value(Meaning::Amount, true, 1.0, Coding::Srgb), 0.75);
        near(value(Meaning::Colour, true, 1.0, Coding::Srgb), srgb::decode(0.75));
        near(value(Meaning::Amount, false, 1.0, Coding::Linear), srgb::decode(0.25));
        near(value(Meaning::Alpha, false, 1.0, Coding::Srgb), 0.75);
        near(value(Meaning::Alpha, true, 2.0, Coding::Srgb), 0.5);
    }
}
