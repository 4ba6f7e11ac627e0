//! Decoder of material libraries (`.mtl`).
//!
//! Read are `newmtl`, `Kd`, `Ks`, `Ke`, `Ns`, `Ni`, `d`, `Tr`, `Tf`, `illum`, and maps with
//! the options that say how they lie. `Ka` means nothing where light is computed. All else is
//! counted.

use super::lines::Lines;
use super::words::{name, number, words};
use super::{Cause, Error, Limits, WarningKind, check_text};
use crate::tally::Tally;
use traylib_math::{Rgb, Vec2};

/// What a material library holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The materials in the order of the file. Names may repeat; the first one counts.
    pub materials: Vec<Material>,
    /// What was skipped or repaired.
    pub warnings: Tally<WarningKind>,
}

/// A material as it stands in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// `Kd`.
    pub diffuse: Option<Rgb>,
    /// `Ks`.
    pub specular: Option<Rgb>,
    /// `Ke`.
    pub emission: Option<Rgb>,
    /// `Ns`.
    pub exponent: Option<f32>,
    /// `Ni`, the index of refraction.
    pub index: Option<f32>,
    /// `d`: 1 is opaque.
    pub dissolve: Option<f32>,
    /// `Tr`: 1 is clear.
    pub transparency: Option<f32>,
    /// `Tf`, the colour of what passes.
    pub filter: Option<Rgb>,
    /// `illum`.
    pub illumination: Option<u32>,
    /// Its maps in the order of the file.
    pub maps: Vec<(MapKind, Map)>,
}

/// What a map is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MapKind {
    /// `map_Kd`.
    Diffuse,
    /// `map_Ks`.
    Specular,
    /// `map_d`.
    Dissolve,
    /// `map_Bump` or `bump`.
    Bump,
    /// `map_Ke`.
    Emission,
    /// `norm`, normals.
    Normal,
    /// `map_Ns`.
    Exponent,
    /// `disp`, which moves the surface.
    Displacement,
    /// `decal`.
    Decal,
    /// `refl`.
    Reflection,
}

/// A picture, and how it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Its file as it stands there.
    pub file: String,
    /// `-s`: how often it fits along u and v.
    pub scale: Vec2,
    /// `-o`: what is added to u and v after that.
    pub offset: Vec2,
    /// `-clamp on`: it is there once.
    pub clamp: bool,
    /// `-bm`: factor on a bump map.
    pub height: f32,
    /// `-imfchan`: which channel of the picture.
    pub channel: Option<char>,
}

/// Decodes a material library.
///
/// # Errors
/// A statement that is read makes no sense: the first, with its line.
pub fn decode(bytes: &[u8], limits: Limits) -> Result<Library, Error> {
    check_text(bytes, limits)?;
    let mut library = Library::default();
    for (line, text) in Lines::new(bytes) {
        library.statement(&text).map_err(|cause| Error::Line { line, cause })?;
    }
    Ok(library)
}

impl Library {
    fn statement(&mut self, line: &[u8]) -> Result<(), Cause> {
        let mut words = words(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        if keyword == b"newmtl" {
            self.materials.push(Material { name: name(line), ..Material::default() });
            return Ok(());
        }
        let Some(mut material) = self.materials.pop() else {
            self.warnings.add(WarningKind::statement(keyword));
            return Ok(());
        };
        let done = self.of_material(&mut material, line, keyword, words);
        self.materials.push(material);
        done
    }

    fn of_material<'a>(
        &mut self,
        material: &mut Material,
        line: &[u8],
        keyword: &[u8],
        mut words: impl Iterator<Item = &'a [u8]>,
    ) -> Result<(), Cause> {
        match keyword {
            b"Kd" => material.diffuse = self.colour("Kd", words)?.or(material.diffuse),
            b"Ks" => material.specular = self.colour("Ks", words)?.or(material.specular),
            b"Ke" => material.emission = self.colour("Ke", words)?.or(material.emission),
            b"Tf" => material.filter = self.colour("Tf", words)?.or(material.filter),
            b"Ns" => material.exponent = Some(one("Ns", words.next())?),
            b"Ni" => material.index = Some(one("Ni", words.next())?),
            b"Tr" => material.transparency = Some(one("Tr", words.next())?),
            b"d" => {
                let mut word = words.next();
                if word == Some(b"-halo") {
                    self.warnings.add(WarningKind::Halo);
                    word = words.next();
                }
                material.dissolve = Some(one("d", word)?);
            }
            b"illum" => material.illumination = Some(one("illum", words.next())? as u32),
            b"Ka" | b"map_Ka" => {}
            _ => match map_kind(keyword) {
                Some(kind) => material.maps.extend(self.map(line).map(|map| (kind, map))),
                None => self.warnings.add(WarningKind::statement(keyword)),
            },
        }
        Ok(())
    }

    /// Three bands, or one for all; `None` of a spectrum.
    fn colour<'a>(
        &mut self,
        keyword: &'static str,
        mut words: impl Iterator<Item = &'a [u8]>,
    ) -> Result<Option<Rgb>, Cause> {
        let first = words.next();
        if matches!(first, Some(b"spectral" | b"xyz")) {
            self.warnings.add(WarningKind::Spectrum);
            return Ok(None);
        }
        let r = one(keyword, first)?;
        let g = words.next().map_or(Ok(r), number)?;
        let b = words.next().map_or(Ok(g), number)?;
        Ok(Some(Rgb::new(r, g, b)))
    }

    /// Options, and then the rest of the line as a name of a file.
    fn map(&mut self, line: &[u8]) -> Option<Map> {
        let text = name(line);
        let mut map = Map {
            file: String::new(),
            scale: Vec2::ONE,
            offset: Vec2::ZERO,
            clamp: false,
            height: 1.0,
            channel: None,
        };
        let mut rest = Rest(&text);
        while let Some(option) = rest.option() {
            match option {
                "-s" => map.scale = rest.up_to_three(map.scale),
                "-o" => map.offset = rest.up_to_three(map.offset),
                "-clamp" => map.clamp = rest.word() == "on",
                "-bm" => map.height = rest.number().unwrap_or(map.height),
                "-imfchan" => map.channel = rest.word().chars().next(),
                // How pictures are filtered: nothing of it changes what they show from near.
                "-blendu" | "-blendv" | "-cc" | "-texres" | "-boost" => _ = rest.word(),
                "-mm" => {
                    let (base, gain) = (rest.number(), rest.number());
                    if (base, gain) != (Some(0.0), Some(1.0)) {
                        self.warnings.add(WarningKind::option("-mm"));
                    }
                }
                "-t" => {
                    _ = rest.up_to_three(Vec2::ZERO);
                    self.warnings.add(WarningKind::option("-t"));
                }
                other => {
                    _ = rest.word();
                    self.warnings.add(WarningKind::option(other));
                }
            }
        }
        map.file = rest.0.trim().to_string();
        (!map.file.is_empty()).then_some(map)
    }
}

fn one(keyword: &'static str, word: Option<&[u8]>) -> Result<f32, Cause> {
    word.map_or(Err(Cause::Missing { keyword, wanted: "a number" }), number)
}

fn map_kind(keyword: &[u8]) -> Option<MapKind> {
    Some(match keyword.to_ascii_lowercase().as_slice() {
        b"map_kd" => MapKind::Diffuse,
        b"map_ks" => MapKind::Specular,
        b"map_d" => MapKind::Dissolve,
        b"map_bump" | b"bump" => MapKind::Bump,
        b"map_ke" => MapKind::Emission,
        b"norm" | b"map_kn" => MapKind::Normal,
        b"map_ns" => MapKind::Exponent,
        b"disp" | b"map_disp" => MapKind::Displacement,
        b"decal" => MapKind::Decal,
        b"refl" | b"map_refl" => MapKind::Reflection,
        _ => return None,
    })
}

/// What is left of a line.
struct Rest<'a>(&'a str);

impl<'a> Rest<'a> {
    /// The next word, which is passed.
    fn word(&mut self) -> &'a str {
        let text = self.0.trim_start();
        let end = text.find(|c: char| c.is_ascii_whitespace()).unwrap_or(text.len());
        self.0 = &text[end..];
        &text[..end]
    }

    /// The next word if it is an option.
    fn option(&mut self) -> Option<&'a str> {
        let is_option = |text: &str| {
            let mut signs = text.chars();
            signs.next() == Some('-') && signs.next().is_some_and(char::is_alphabetic)
        };
        is_option(self.0.trim_start()).then(|| self.word())
    }

    /// The next word if it is a finite number.
    fn number(&mut self) -> Option<f32> {
        let before = self.0;
        let number = self.word().parse().ok().filter(|value: &f32| value.is_finite());
        if number.is_none() {
            self.0 = before;
        }
        number
    }

    /// One number for u, or one more for v, or a third that is for solid textures.
    fn up_to_three(&mut self, usual: Vec2) -> Vec2 {
        let u = self.number().unwrap_or(usual.x);
        let v = self.number().unwrap_or(usual.y);
        _ = self.number();
        Vec2::new(u, v)
    }
}
