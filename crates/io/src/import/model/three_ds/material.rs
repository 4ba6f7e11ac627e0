//! From 3D Studio's materials to models.

use super::maps::MapImporter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::model::appearance::Appearance;
use crate::three_ds::{self, Shading};
use traylib_geometry::Sides;
use traylib_materials as materials;
use traylib_math::Rgb;

/// Makes a material that can be rendered.
///
/// Colours are taken as coded by the sRGB curve. kd = d, ks = s·k (metal: d·k)
/// and n = 2^(10·g), for diffuse d, specular s, strength k and glossiness g:
/// the exponent as in the viewer of lib3ds.
///
/// # Errors
/// A number makes no material.
pub(super) fn imported(
    material: &three_ds::Material,
    importer: &mut MapImporter<'_>,
) -> Result<ImportedMaterial, materials::Error> {
    let diffuse = linear(material.diffuse);
    let tint = match material.shading {
        Shading::Metal => diffuse,
        Shading::Wire | Shading::Flat | Shading::Gouraud | Shading::Phong => {
            linear(material.specular)
        }
    };
    let appearance = Appearance {
        diffuse,
        specular: tint * material.shininess_strength,
        exponent: (10.0 * material.shininess).exp2(),
        share: 1.0 - material.transparency,
        maps: importer.maps(material),
    };
    let surface = appearance.material(&mut importer.pictures)?;
    let emission = diffuse * material.glow();
    let sides = if material.two_sided { Sides::Both } else { Sides::Front };
    Ok(ImportedMaterial { name: material.name.clone(), surface, sides, emission })
}

pub(super) fn linear(coded: Rgb) -> Rgb {
    Rgb::from(coded.to_array().map(crate::srgb::decode))
}
