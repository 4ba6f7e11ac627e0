//! Surfaces of which a part is there.

use super::Importer;
use super::fields::Fields;
use super::paint::Paint;
use super::surface::{Backing, Surface};
use crate::Error;
use crate::import::model::appearance::even;
use traylib_materials::{Lambert, Layer, Maps, Material, MaxPhong, Mirror, Phong, SurfaceModel};
use traylib_math::Rgb;

impl Importer<'_> {
    pub(super) fn mask(&mut self, fields: &mut Fields<'_>, depth: usize) -> Result<Surface, Error> {
        let Paint { colour, layer } = self.paint(fields, "opacity", 0.5, Rgb::WHITE);
        let layer = layer.and_then(|layer| self.pictures.textures.opacity(layer));
        let surface = (*self.nested(fields, depth)?[0]).clone();
        let share = colour.luminance();
        let partly = |material| partly(material, share, layer.clone());
        let backing = match surface.backing {
            Backing::Same => Backing::Same,
            Backing::Black => Backing::Black,
            Backing::Other(back) => Backing::Other(partly(back)),
        };
        Ok(Surface { front: partly(surface.front), backing })
    }
}

/// A material of which only a part is there: where a picture says, or this share everywhere.
fn partly(material: Material, share: f32, layer: Option<Layer>) -> Material {
    if let (None, Some(thinner)) = (&layer, thinner(&material, share)) {
        return thinner;
    }
    let layer = layer.or_else(|| even(share));
    let maps = material.maps.map_or_else(Maps::default, |maps| *maps);
    let opacity = maps.opacity.clone().or(layer);
    Material { maps: Some(Box::new(Maps { opacity, ..maps })), ..material }
}

/// The same without a picture of opacity, which shows on all shapes; `None` of glass and where
/// there are pictures.
fn thinner(material: &Material, share: f32) -> Option<Material> {
    if material.maps.is_some() {
        return None;
    }
    let model = match material.model {
        SurfaceModel::Lambert(m) => {
            SurfaceModel::Lambert(Lambert::new(m.reflectance() * share).ok()?)
        }
        SurfaceModel::Phong(m) => {
            let parts = [m.diffuse(), m.specular()].map(|part| part * share);
            SurfaceModel::Phong(Phong::new(parts[0], parts[1], m.exponent()).ok()?)
        }
        SurfaceModel::MaxPhong(m) => {
            SurfaceModel::MaxPhong(MaxPhong::new(m.specular() * share, m.exponent()).ok()?)
        }
        SurfaceModel::Mirror(m) => {
            SurfaceModel::Mirror(Mirror::new(m.reflectance() * share, m.diffuse() * share).ok()?)
        }
        SurfaceModel::Sheet(_) | SurfaceModel::Dielectric(_) => return None,
    };
    let through = material.through * share + Rgb::splat(1.0 - share);
    Some(Material { model, through, maps: None })
}
