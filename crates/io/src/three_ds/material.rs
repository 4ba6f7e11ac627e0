//! Materials of a 3DS file.

use super::chunk::Reader;
use super::{WarningKind, Warnings};
use traylib_math::Rgb;

/// How the material was meant to be shaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// Wire, flat, Gouraud or Phong: the highlight has the specular colour.
    #[default]
    Phong,
    /// Metal: the highlight has the diffuse colour.
    Metal,
}

/// A material as stored. Colours are as in the file, in 0..1 and coded for a
/// screen; what a chunk leaves out has 3D Studio's default.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name, by which faces refer to it.
    pub name: String,
    /// Diffuse colour.
    pub diffuse: Rgb,
    /// Colour of the highlight.
    pub specular: Rgb,
    /// Glossiness in 0..1: how narrow the highlight is.
    pub shininess: f32,
    /// Strength of the highlight in 0..1.
    pub shininess_strength: f32,
    /// Whether the back is to be seen too.
    pub two_sided: bool,
    /// Which colour the highlight has.
    pub shading: Shading,
}

impl Default for Material {
    /// 3D Studio's grey.
    fn default() -> Self {
        Self {
            name: String::new(),
            diffuse: Rgb::splat(0.588),
            specular: Rgb::splat(0.898),
            shininess: 0.1,
            shininess_strength: 0.05,
            two_sided: false,
            shading: Shading::Phong,
        }
    }
}

/// Reads a material chunk (AFFF).
pub(super) fn decode(mut reader: Reader<'_>, warnings: &mut Warnings) -> Material {
    let mut material = Material::default();
    while let Some((id, mut body)) = reader.next_chunk(warnings) {
        match id {
            0xa000 => material.name = body.string(),
            0xa020 => set(&mut material.diffuse, colour(body, warnings)),
            0xa030 => set(&mut material.specular, colour(body, warnings)),
            0xa040 => set(&mut material.shininess, percent(body, warnings)),
            0xa041 => set(&mut material.shininess_strength, percent(body, warnings)),
            0xa050 => warn_if_set(body, WarningKind::TransparencySkipped, warnings),
            0xa080 => warnings.add(WarningKind::SelfIlluminationSkipped),
            0xa081 => material.two_sided = true,
            0xa084 => warn_if_set(body, WarningKind::SelfIlluminationSkipped, warnings),
            0xa100 if body.u16() == Some(4) => material.shading = Shading::Metal,
            _ if is_map(id) => warnings.add(WarningKind::MapSkipped),
            _ => {}
        }
    }
    material
}

fn is_map(id: u16) -> bool {
    const MAPS: [u16; 8] = [0xa200, 0xa33a, 0xa204, 0xa210, 0xa230, 0xa33c, 0xa33d, 0xa220];
    MAPS.contains(&id)
}

fn set<T>(field: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *field = value;
    }
}

fn warn_if_set(body: Reader<'_>, kind: WarningKind, warnings: &mut Warnings) {
    if percent(body, warnings).is_some_and(|p| p > 0.0) {
        warnings.add(kind);
    }
}

/// The first plain colour inside a chunk, else the first of those meant for
/// output in a gamma-corrected pipeline.
fn colour(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<Rgb> {
    let mut second_choice = None;
    while let Some((id, mut body)) = reader.next_chunk(warnings) {
        let value = match id {
            0x0010 | 0x0013 => three(|| body.f32()),
            0x0011 | 0x0012 => three(|| body.byte().map(|b| f32::from(b) / 255.0)),
            _ => None,
        };
        let Some(value) = value else { continue };
        if !value.is_finite() {
            warnings.add(WarningKind::ColourNotFinite);
            continue;
        }
        let value = Rgb::from(value.to_array().map(|band| band.clamp(0.0, 1.0)));
        if matches!(id, 0x0010 | 0x0011) {
            return Some(value);
        }
        second_choice = second_choice.or(Some(value));
    }
    second_choice
}

fn three(mut band: impl FnMut() -> Option<f32>) -> Option<Rgb> {
    Some(Rgb::new(band()?, band()?, band()?))
}

/// A percentage inside a chunk, as a fraction in 0..1.
fn percent(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<f32> {
    while let Some((id, mut body)) = reader.next_chunk(warnings) {
        let value = match id {
            0x0030 => body.u16().map(|stored| f32::from(stored.cast_signed()) / 100.0),
            // Some writers store percent here too.
            0x0031 => body.f32().map(|stored| if stored > 1.0 { stored / 100.0 } else { stored }),
            _ => None,
        };
        if let Some(value) = value.filter(|value| value.is_finite()) {
            return Some(value.clamp(0.0, 1.0));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(bytes: &[u8]) -> (Material, Warnings) {
        let mut warnings = Warnings::default();
        (decode(Reader::new(bytes), &mut warnings), warnings)
    }

    #[test]
    fn what_is_left_out_is_the_default() {
        assert_eq!(decoded(&[]).0, Material::default());
        // A diffuse colour chunk without a colour in it.
        assert_eq!(decoded(&[0x20, 0xa0, 6, 0, 0, 0]).0, Material::default());
    }

    #[test]
    fn the_plain_colour_wins_over_the_corrected_one() {
        let bytes = [
            0x20, 0xa0, 24, 0, 0, 0, 0x12, 0, 9, 0, 0, 0, 9, 9, 9, 0x11, 0, 9, 0, 0, 0, 255, 0, 51,
        ];
        assert_eq!(decoded(&bytes).0.diffuse, Rgb::new(1.0, 0.0, 0.2));
        // Without the second colour the first is all there is.
        let mut short = bytes[..15].to_vec();
        short[2] = 15;
        assert_eq!(decoded(&short).0.diffuse, Rgb::splat(9.0 / 255.0));
    }

    #[test]
    fn percentages_come_as_integers_or_floats() {
        let integer = [0x40, 0xa0, 14, 0, 0, 0, 0x30, 0, 8, 0, 0, 0, 25, 0];
        assert_eq!(decoded(&integer).0.shininess, 0.25);
        for (stored, expected) in [(0.5_f32, 0.5), (40.0, 0.4), (-1.0, 0.0), (f32::NAN, 0.1)] {
            let mut float = vec![0x40, 0xa0, 16, 0, 0, 0, 0x31, 0, 10, 0, 0, 0];
            float.extend(stored.to_le_bytes());
            assert_eq!(decoded(&float).0.shininess, expected, "{stored}");
        }
    }

    #[test]
    fn flags_and_maps_are_noticed() {
        let bytes = [0x81, 0xa0, 6, 0, 0, 0, 0x00, 0xa1, 8, 0, 0, 0, 4, 0, 0x00, 0xa2, 6, 0, 0, 0];
        let (material, warnings) = decoded(&bytes);
        assert!(material.two_sided);
        assert_eq!(material.shading, Shading::Metal);
        assert_eq!(warnings.count(WarningKind::MapSkipped), 1);
    }
}
