//! Decoder of material libraries (`.mtl`).
//!
//! Read are `newmtl`, `Kd`, `Ks`, `Ke`, `Ns`, `Ni`, `d`, `Tr`, `Tf`, `illum`, and maps with
//! the options that say how they lie. `Ka` means nothing where light is computed. All else is
//! counted.

mod map;

pub use map::{Map, MapKind};

use super::lines::Lines;
use super::words::{name, number, words};
use super::{Cause, Error, Limits, WarningKind, check_text};
use crate::warning_counts::WarningCounts;
use traylib_math::Rgb;

/// The contents of a material library.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The materials in the order of the file. Names may repeat; the first one counts.
    pub materials: Vec<Material>,
    /// The warnings: what was skipped or repaired.
    pub warnings: WarningCounts<WarningKind>,
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
        let done = self.property(&mut material, line, keyword, words);
        self.materials.push(material);
        done
    }

    fn property<'a>(
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
            _ => match MapKind::of(keyword) {
                Some(kind) => {
                    let map = Map::read(&name(line), &mut self.warnings);
                    material.maps.extend(map.map(|map| (kind, map)));
                }
                None => self.warnings.add(WarningKind::statement(keyword)),
            },
        }
        Ok(())
    }

    /// Reads three bands, or one for all; `None` of a spectrum.
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
}

fn one(keyword: &'static str, word: Option<&[u8]>) -> Result<f32, Cause> {
    word.map_or(Err(Cause::Missing { keyword, wanted: "a number" }), number)
}
