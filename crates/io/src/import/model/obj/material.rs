//! From MTL's materials to models.
//!
//! | material | model |
//! |---|---|
//! | Kd | Lambert; linear, grey of ½ if none is given |
//! | Ks, Ns | Phong with ks = Ks, n = Ns, unless `illum` is 0 or 1; scaled down with kd if both reflect more than arrives |
//! | d, else 1 − Tr, of which 0 is taken for 1 | this part of the light is scattered, the rest passes straight |
//! | Ke | radiance, as it is |
//! | map_Kd, map_Ks, map_d | pictures times Kd, Ks, d |
//! | map_Bump | height, of which 1 is a hundredth of a unit of u times `-bm` |

use crate::import::imported_material::ImportedMaterial;
use crate::import::model::appearance::{Appearance, SHARPEST};
use crate::import::model::beside::Beside;
use crate::import::model::pictures::Pictures;
use crate::import::model::plain::GREY;
use crate::import::textures::{Meaning, Usage};
use crate::obj::mtl::{Map, MapKind, Material};
use traylib_geometry::Sides;
use traylib_materials::{self as materials, Bump, Layer, Maps, Tiling};
use traylib_math::Rgb;
use traylib_math::glam::Affine2;

/// Height of a bump map, in lengths of a unit of u.
const BUMP_HEIGHT: f32 = 0.01;

/// Turns materials of a library into ours.
pub(super) struct MaterialImporter<'a> {
    pub(super) beside: &'a Beside,
    pub(super) pictures: Pictures<'a>,
}

impl MaterialImporter<'_> {
    /// Makes a material that can be rendered.
    ///
    /// # Errors
    /// A number makes no material.
    pub(super) fn imported(
        &mut self,
        material: &Material,
    ) -> Result<ImportedMaterial, materials::Error> {
        let share = self.share(material);
        let [diffuse, specular] = self.colours(material);
        let appearance = Appearance {
            diffuse,
            specular,
            exponent: material.exponent.unwrap_or(1.0).clamp(0.0, SHARPEST),
            share,
            maps: self.maps(material, [diffuse, specular], share),
        };
        let surface = appearance.material(&mut self.pictures)?;
        let (name, emission) = (material.name.clone(), self.emission(material));
        Ok(ImportedMaterial { name, surface, sides: Sides::Both, emission })
    }

    fn warn(&mut self, what: impl Into<String>) {
        self.pictures.counter.add(what);
    }

    /// Returns how much of the surface is there.
    fn share(&mut self, material: &Material) -> f32 {
        let clear = matches!(material.illumination, Some(6 | 7));
        if clear && material.index.is_some_and(|index| index != 1.0) {
            self.warn("refraction skipped (`illum` 6 or 7), light passes straight");
        }
        if material.filter.is_some_and(|filter| filter != Rgb::WHITE) {
            self.warn("colour of what passes (`Tf`) skipped");
        }
        material.dissolve.unwrap_or_else(|| self.opacity(material)).clamp(0.0, 1.0)
    }

    /// Returns how much is there by what lets light through alone. Nobody models what is not
    /// there at all, but VTK's exporter (of 2026) writes the opacity as `Tr`.
    fn opacity(&mut self, material: &Material) -> f32 {
        match material.transparency {
            Some(clear) if clear >= 1.0 => {
                self.warn("material that lets all light through (`Tr 1`) taken for opaque");
                1.0
            }
            Some(clear) => 1.0 - clear,
            None => 1.0,
        }
    }

    /// Returns kd and ks, brought into 0..1.
    fn colours(&mut self, material: &Material) -> [Rgb; 2] {
        let has = |wanted| material.maps.iter().any(|(kind, _)| *kind == wanted);
        let diffuse = material
            .diffuse
            .unwrap_or_else(|| Rgb::splat(if has(MapKind::Diffuse) { 1.0 } else { GREY }));
        let shines = !matches!(material.illumination, Some(0 | 1));
        let usual = if has(MapKind::Specular) { Rgb::WHITE } else { Rgb::BLACK };
        let specular = if shines { material.specular.unwrap_or(usual) } else { Rgb::BLACK };
        [diffuse, specular].map(|colour| {
            if colour != colour.saturated() {
                self.warn("colour of a material not from 0 to 1, brought there");
            }
            colour.saturated()
        })
    }

    fn emission(&mut self, material: &Material) -> Rgb {
        let emission = material.emission.unwrap_or(Rgb::BLACK);
        if material.maps.iter().any(|(kind, _)| *kind == MapKind::Emission) {
            self.warn("picture of what a surface emits skipped, and what it emits");
            return Rgb::BLACK;
        }
        if emission.min_band() < 0.0 {
            self.warn("emission that takes light away skipped");
        }
        Rgb::from(emission.to_array().map(|band| band.max(0.0)))
    }

    /// Loads the maps that are rendered.
    fn maps(&mut self, material: &Material, [diffuse, specular]: [Rgb; 2], share: f32) -> Maps {
        let mut maps = Maps::default();
        for (kind, map) in &material.maps {
            match kind {
                MapKind::Diffuse => maps.diffuse = self.layer(map, Meaning::Colour, diffuse),
                MapKind::Specular if specular.is_black() => {}
                MapKind::Specular => maps.specular = self.layer(map, Meaning::Colour, specular),
                MapKind::Dissolve => {
                    let is_alpha = map.channel == Some('m');
                    let meaning = if is_alpha { Meaning::Alpha } else { Meaning::Amount };
                    maps.opacity = self.layer(map, meaning, Rgb::splat(share));
                }
                MapKind::Bump => maps.bump = self.bump(map),
                // Told with what the surface emits.
                MapKind::Emission => {}
                MapKind::Normal
                | MapKind::Exponent
                | MapKind::Displacement
                | MapKind::Decal
                | MapKind::Reflection => self.warn(format!("{} skipped", name(*kind))),
            }
        }
        maps
    }

    fn layer(&mut self, map: &Map, meaning: Meaning, factor: Rgb) -> Option<Layer> {
        let usage = Usage { meaning, negative: false, factor };
        let texture = self.pictures.load(&map.file, self.beside.find(&map.file), usage)?;
        let placement = Affine2::from_scale_angle_translation(map.scale, 0.0, map.offset);
        let tiling = if map.clamp { Tiling::Once } else { Tiling::Repeat };
        let usable = placement.is_finite() && map.scale.cmpne(traylib_math::Vec2::ZERO).all();
        if !usable {
            self.warn("picture of no extent skipped");
        }
        usable.then(|| Layer { placement, tiling, ..Layer::new(texture) })
    }

    fn bump(&mut self, map: &Map) -> Option<Bump> {
        let layer = self.layer(map, Meaning::Amount, Rgb::WHITE)?;
        Some(Bump { layer, height: BUMP_HEIGHT * map.height })
    }
}

fn name(kind: MapKind) -> &'static str {
    match kind {
        MapKind::Diffuse => "diffuse map",
        MapKind::Specular => "specular map",
        MapKind::Dissolve => "opacity map",
        MapKind::Bump => "bump map",
        MapKind::Emission => "map of emission",
        MapKind::Normal => "map of normals",
        MapKind::Exponent => "map of exponents",
        MapKind::Displacement => "displacement map",
        MapKind::Decal => "decal",
        MapKind::Reflection => "reflection map",
    }
}
