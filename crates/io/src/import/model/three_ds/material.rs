//! From 3D Studio's materials to models.

use super::maps::MapImporter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::model::gloss;
use crate::three_ds::{self, Shading};
use traylib_geometry::Sides;
use traylib_materials::{self as materials, Material, SurfaceModel};
use traylib_math::Rgb;

/// A material as it can be rendered.
pub(super) fn imported(
    material: &three_ds::Material,
    importer: &mut MapImporter<'_>,
) -> Result<ImportedMaterial, materials::Error> {
    let maps = importer.maps(material);
    // A texture of opacity says the same where there are others.
    let clear = if maps.is_none() { material.transparency } else { 0.0 };
    let (model, was_scaled) = surface_model(material, 1.0 - clear)?;
    if was_scaled {
        importer.counter.add(gloss::SCALED);
    }
    let emission = linear(material.diffuse) * material.glow();
    let sides = if material.two_sided { Sides::Both } else { Sides::Front };
    let material_of = Material { model, through: Rgb::splat(clear), maps };
    Ok(ImportedMaterial { name: material.name.clone(), surface: material_of, sides, emission })
}

/// The model nearest to a 3DS material of which this share is there, and whether
/// it had to be scaled down.
///
/// Colours are taken as coded by the sRGB curve. kd = d, ks = s·k (metal: d·k)
/// and n = 2^(10·g), for diffuse d, specular s, strength k and glossiness g:
/// the exponent as in the viewer of lib3ds. Where kd + ks exceeds one both are
/// divided by the largest band of the sum.
fn surface_model(
    material: &three_ds::Material,
    share: f32,
) -> Result<(SurfaceModel, bool), materials::Error> {
    let diffuse = linear(material.diffuse);
    let tint = match material.shading {
        Shading::Metal => diffuse,
        Shading::Wire | Shading::Flat | Shading::Gouraud | Shading::Phong => {
            linear(material.specular)
        }
    };
    let specular = tint * material.shininess_strength;
    let exponent = (10.0 * material.shininess).exp2();
    gloss::surface_model([diffuse, specular], exponent, share)
}

pub(super) fn linear(coded: Rgb) -> Rgb {
    Rgb::from(coded.to_array().map(crate::srgb::decode))
}
