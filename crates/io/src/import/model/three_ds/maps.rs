//! From 3D Studio's maps to textures.
//!
//! Rendered are texture 1 as the diffuse part, the specular map times the
//! strength of the highlight, the opacity map, and the bump map, whose white is
//! a hundredth of a unit of u above its black: 3D Studio gives no height.

use crate::import::counter::Counter;
use crate::import::model::folder::Folder;
use crate::import::textures::{Meaning, Textures, Usage};
use crate::three_ds::{Map, MapKind, Material};
use std::sync::Arc;
use traylib_materials::{Bump, Layer, Maps, Texture};
use traylib_math::{Grid, Rgb};

/// Height of a bump map of full strength, in lengths of a unit of u.
const BUMP_HEIGHT: f32 = 0.01;

/// Turns the maps of a file's materials into textures.
pub(super) struct MapImporter<'a> {
    pub(super) folder: Folder,
    pub(super) textures: &'a mut Textures,
    pub(super) counter: &'a mut Counter,
}

impl MapImporter<'_> {
    /// The maps of a material that are rendered; `None` if there are none.
    pub(super) fn maps(&mut self, material: &Material) -> Option<Box<Maps>> {
        self.counter.add_many("mask of a map skipped", material.masks.len() as u32);
        let mut maps = Maps::default();
        for (kind, map) in &material.maps {
            if map.flags & (Map::TINT | Map::RGB_TINT) != 0 {
                self.counter.add("tint of a map skipped");
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
                | MapKind::Reflection => self.counter.add(format!("{} map skipped", name(*kind))),
            }
        }
        if maps == Maps::default() {
            return None;
        }
        // Textures replace colours, so that what is behind cannot be taken off them.
        if maps.opacity.is_none() && material.transparency > 0.0 {
            maps.opacity = even(1.0 - material.transparency);
        }
        maps.opacity = maps.opacity.and_then(|layer| self.textures.opacity(layer));
        Some(Box::new(maps))
    }

    fn layer(&mut self, map: &Map, meaning: Meaning, factor: f32) -> Option<Layer> {
        let name = map.file_name();
        if name.is_empty() || map.strength == 0.0 {
            return None;
        }
        let Some(file) = self.folder.find(name) else {
            self.counter.add(format!("picture `{name}` not found, shown without"));
            return None;
        };
        let negative = map.has(Map::NEGATIVE);
        let usage = Usage { meaning, negative, factor: Rgb::splat(factor) };
        let texture = self.textures.load(&file, usage).map_err(|cause| self.counter.add(cause));
        let (placement, tiling, strength) = (map.placement(), map.tiling(), map.strength);
        let usable = placement.is_finite();
        texture.ok().filter(|_| usable).map(|texture| Layer {
            texture,
            placement,
            tiling,
            strength,
        })
    }

    fn bump(&mut self, map: &Map) -> Option<Bump> {
        let layer = self.layer(map, Meaning::Amount, 1.0)?;
        let height = BUMP_HEIGHT * layer.strength;
        Some(Bump { layer: Layer { strength: 1.0, ..layer }, height })
    }
}

/// The same everywhere.
fn even(value: f32) -> Option<Layer> {
    let texture = Texture::new(Grid::filled(1, 1, Rgb::splat(value)))?;
    Some(Layer::new(Arc::new(texture)))
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
