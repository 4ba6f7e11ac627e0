//! From 3D Studio's maps to textures.
//!
//! Rendered are texture 1 as the diffuse part, the specular map times the
//! strength of the highlight, the opacity map, and the bump map, whose white is
//! a hundredth of a unit of u above its black: 3D Studio gives no height.

use crate::import::model::folder::Folder;
use crate::import::model::pictures::Pictures;
use crate::import::textures::{Meaning, Usage};
use crate::three_ds::{Map, MapKind, Material};
use traylib_materials::{Bump, Layer, Maps};
use traylib_math::Rgb;

/// Height of a bump map of full strength, in lengths of a unit of u.
const BUMP_HEIGHT: f32 = 0.01;

/// Turns the maps of a file's materials into textures.
pub(super) struct MapImporter<'a> {
    pub(super) folder: Folder,
    pub(super) pictures: Pictures<'a>,
}

impl MapImporter<'_> {
    /// Loads the maps of a material that are rendered.
    pub(super) fn maps(&mut self, material: &Material) -> Maps {
        self.pictures.counter.add_many("mask of a map skipped", material.masks.len() as u32);
        let mut maps = Maps::default();
        for (kind, map) in &material.maps {
            if map.flags & (Map::TINT | Map::RGB_TINT) != 0 {
                self.pictures.counter.add("tint of a map skipped");
            }
            match kind {
                MapKind::Texture1 => maps.diffuse = self.layer(map, Meaning::Colour, 1.0),
                MapKind::Specular => {
                    let strength = material.shininess_strength;
                    maps.specular = self.layer(map, Meaning::Colour, strength);
                }
                MapKind::Opacity => {
                    let alpha = map.has(Map::ALPHA_SOURCE) && !map.has(Map::IGNORE_ALPHA);
                    let meaning = if alpha { Meaning::Alpha } else { Meaning::Amount };
                    maps.opacity = self.layer(map, meaning, 1.0);
                }
                MapKind::Bump => maps.bump = self.bump(map),
                MapKind::Texture2
                | MapKind::Shininess
                | MapKind::SelfIllumination
                | MapKind::Reflection => {
                    self.pictures.counter.add(format!("{} map skipped", name(*kind)));
                }
            }
        }
        maps
    }

    fn layer(&mut self, map: &Map, meaning: Meaning, factor: f32) -> Option<Layer> {
        let name = map.file_name();
        if name.is_empty() || map.strength == 0.0 {
            return None;
        }
        let negative = map.has(Map::NEGATIVE);
        let usage = Usage { meaning, negative, factor: Rgb::splat(factor) };
        let texture = self.pictures.load(name, self.folder.find(name), usage)?;
        let (placement, tiling, strength) = (map.placement(), map.tiling(), map.strength);
        placement.is_finite().then_some(Layer { texture, placement, tiling, strength })
    }

    fn bump(&mut self, map: &Map) -> Option<Bump> {
        let layer = self.layer(map, Meaning::Amount, 1.0)?;
        let height = BUMP_HEIGHT * layer.strength;
        Some(Bump { layer: Layer { strength: 1.0, ..layer }, height })
    }
}

fn name(kind: MapKind) -> &'static str {
    match kind {
        MapKind::Texture1 => "texture",
        MapKind::Texture2 => "second texture",
        MapKind::Opacity => "opacity",
        MapKind::Bump => "bump",
        MapKind::Specular => "specular",
        MapKind::Shininess => "shininess",
        MapKind::SelfIllumination => "self-illumination",
        MapKind::Reflection => "reflection",
    }
}
