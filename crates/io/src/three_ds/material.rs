//! Materials of a 3DS file.

use super::Warnings;
use super::chunk::{Reader, set};
use super::colour::{colour, fraction};
use super::limits::Remaining;
use super::map::{self, Map, MapKind};
use traylib_math::Rgb;

/// The shading that the material was meant to have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// Edges only.
    Wire,
    /// One shade a face.
    Flat,
    /// Shades between those of the corners.
    Gouraud,
    /// A highlight of the specular colour.
    #[default]
    Phong,
    /// A highlight of the diffuse colour.
    Metal,
}

impl Shading {
    fn of(stored: u16) -> Option<Self> {
        [Self::Wire, Self::Flat, Self::Gouraud, Self::Phong, Self::Metal]
            .get(usize::from(stored))
            .copied()
    }
}

/// Marks of a material that mostly say how to display it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is a chunk that is there or is not")]
pub struct MaterialFlags {
    /// Maps are decals.
    pub decal: bool,
    /// True if the light behind is added, not filtered.
    pub additive_transparency: bool,
    /// Shown as wires.
    pub wire: bool,
    /// Thickness of wires in units of the file, not in pixels.
    pub wire_in_units: bool,
    /// Each face has the whole map.
    pub face_map: bool,
    /// Transparency falls off inwards.
    pub falloff_in: bool,
    /// Highlights are softened.
    pub soften: bool,
    /// True if the picture that it reflects was to be drawn by 3D Studio.
    pub automatic_reflection: bool,
}

impl MaterialFlags {
    fn read(&mut self, chunk: u16) {
        match chunk {
            0xa082 => self.decal = true,
            0xa083 => self.additive_transparency = true,
            0xa085 => self.wire = true,
            0xa088 => self.face_map = true,
            0xa08a => self.falloff_in = true,
            0xa08c => self.soften = true,
            0xa08e => self.wire_in_units = true,
            0xa310 => self.automatic_reflection = true,
            _ => {}
        }
    }
}

/// A material as stored. Colours are as in the file, in 0..1 and coded for a
/// screen, percentages are fractions in 0..1; what a chunk leaves out has 3D
/// Studio's default.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name, by which faces refer to it.
    pub name: String,
    /// Ambient colour. It means nothing where light is computed.
    pub ambient: Rgb,
    /// Diffuse colour.
    pub diffuse: Rgb,
    /// Colour of the highlight.
    pub specular: Rgb,
    /// Glossiness: how narrow the highlight is.
    pub shininess: f32,
    /// Strength of the highlight.
    pub shininess_strength: f32,
    /// 0 is opaque.
    pub transparency: f32,
    /// The change of transparency towards the edges.
    pub transparency_falloff: f32,
    /// Blur of what is reflected.
    pub reflection_blur: f32,
    /// Marked as shining by itself, as old programs did.
    pub self_illuminated: bool,
    /// The part of its colour with which it shines by itself; newer programs store it.
    pub self_illumination: Option<f32>,
    /// True if the back is to be seen too.
    pub two_sided: bool,
    /// The shading, on which the colour of the highlight depends.
    pub shading: Shading,
    /// Thickness of wires.
    pub wire_size: f32,
    /// Bump amount beside that of the map.
    pub bump_amount: Option<f32>,
    /// Marks.
    pub flags: MaterialFlags,
    /// Maps, at most one of a kind.
    pub maps: Vec<(MapKind, Map)>,
    /// The masks that the maps show through, at most one of a kind.
    pub masks: Vec<(MapKind, Map)>,
}

impl Default for Material {
    /// 3D Studio's grey.
    fn default() -> Self {
        Self {
            name: String::new(),
            ambient: Rgb::splat(0.588),
            diffuse: Rgb::splat(0.588),
            specular: Rgb::splat(0.898),
            shininess: 0.1,
            shininess_strength: 0.05,
            transparency: 0.0,
            transparency_falloff: 0.0,
            reflection_blur: 0.0,
            self_illuminated: false,
            self_illumination: None,
            two_sided: false,
            shading: Shading::Phong,
            wire_size: 1.0,
            bump_amount: None,
            flags: MaterialFlags::default(),
            maps: Vec::new(),
            masks: Vec::new(),
        }
    }
}

impl Material {
    /// Its map of a kind.
    pub fn map(&self, kind: MapKind) -> Option<&Map> {
        self.maps.iter().find(|(of, _)| *of == kind).map(|(_, map)| map)
    }

    /// Radiance it sends out by itself, as a fraction of its diffuse colour. It
    /// has no unit.
    pub fn glow(&self) -> f32 {
        self.self_illumination.unwrap_or(if self.self_illuminated { 1.0 } else { 0.0 })
    }

    fn read(&mut self, id: u16, mut body: Reader<'_>, warnings: &mut Warnings) {
        match id {
            0xa000 => self.name = body.string(),
            0xa010 => set(&mut self.ambient, colour(body, warnings)),
            0xa020 => set(&mut self.diffuse, colour(body, warnings)),
            0xa030 => set(&mut self.specular, colour(body, warnings)),
            0xa080 => self.self_illuminated = true,
            0xa081 => self.two_sided = true,
            0xa087 => set(&mut self.wire_size, body.number(warnings)),
            0xa100 => set(&mut self.shading, body.u16().and_then(Shading::of)),
            _ => self.read_fraction(id, body, warnings),
        }
    }

    fn read_map(
        &mut self,
        (kind, is_mask): (MapKind, bool),
        body: Reader<'_>,
        warnings: &mut Warnings,
    ) {
        let maps = if is_mask { &mut self.masks } else { &mut self.maps };
        put(maps, kind, map::decode(body, warnings));
    }

    fn read_fraction(&mut self, id: u16, body: Reader<'_>, warnings: &mut Warnings) {
        match id {
            0xa040 => set(&mut self.shininess, fraction(body, warnings)),
            0xa041 => set(&mut self.shininess_strength, fraction(body, warnings)),
            0xa050 => set(&mut self.transparency, fraction(body, warnings)),
            0xa052 => set(&mut self.transparency_falloff, fraction(body, warnings)),
            0xa053 => set(&mut self.reflection_blur, fraction(body, warnings)),
            0xa084 => self.self_illumination = fraction(body, warnings),
            0xa252 => self.bump_amount = fraction(body, warnings),
            _ => self.flags.read(id),
        }
    }
}

/// The last map of a kind counts. Space is made one by one: most materials have
/// one map, and a file may have very many materials.
fn put(maps: &mut Vec<(MapKind, Map)>, kind: MapKind, map: Map) {
    maps.retain(|(of, _)| *of != kind);
    maps.reserve_exact(1);
    maps.push((kind, map));
}

/// Reads a material chunk (AFFF).
pub(super) fn decode(
    mut reader: Reader<'_>,
    warnings: &mut Warnings,
    remaining: &mut Remaining,
) -> Material {
    let mut material = Material::default();
    while let Some((id, body)) = reader.next_chunk(warnings) {
        match MapKind::of(id) {
            Some(kind) if remaining.take_map(warnings) => material.read_map(kind, body, warnings),
            Some(_) => {}
            None => material.read(id, body, warnings),
        }
    }
    material
}

#[cfg(test)]
mod tests;
