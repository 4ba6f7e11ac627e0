//! From 3D Studio's materials to models.

use crate::import::model::Look;
use crate::import::tally::Tally;
use crate::three_ds;
use traylib_geometry::Sides;
use traylib_materials::{self as materials, Lambert, Phong, SurfaceModel};
use traylib_math::Rgb;

/// A material as it can be rendered.
pub(super) fn look(
    material: &three_ds::Material,
    tally: &mut Tally,
) -> Result<Look, materials::Error> {
    let (model, was_scaled) = surface_model(material)?;
    if was_scaled {
        tally.add("material reflecting more than arrives, scaled down");
    }
    let emission = linear(material.diffuse) * material.glow();
    let sides = if material.two_sided { Sides::Both } else { Sides::Front };
    Ok(Look { name: material.name.clone(), material: model.into(), sides, emission })
}

/// The model nearest to a 3DS material, and whether it had to be scaled down.
///
/// Colours are taken as coded by the sRGB curve. kd = d, ks = s·k (metal: d·k)
/// and n = 2^(10·g), for diffuse d, specular s, strength k and glossiness g:
/// the exponent as in the viewer of lib3ds. Where kd + ks exceeds one both are
/// divided by the largest band of the sum.
fn surface_model(material: &three_ds::Material) -> Result<(SurfaceModel, bool), materials::Error> {
    let diffuse = linear(material.diffuse);
    let tint = match material.shading {
        three_ds::Shading::Metal => diffuse,
        _ => linear(material.specular),
    };
    let specular = tint * material.shininess_strength;
    if specular.is_black() {
        return Ok((SurfaceModel::Lambert(Lambert::new(diffuse)?), false));
    }
    let sum = (diffuse + specular).max_band();
    let divisor = sum.max(1.0);
    let exponent = (10.0 * material.shininess).exp2();
    let model = Phong::new(diffuse / divisor, specular / divisor, exponent)?;
    Ok((SurfaceModel::Phong(model), sum > 1.0))
}

pub(super) fn linear(coded: Rgb) -> Rgb {
    Rgb::from(coded.to_array().map(crate::srgb::decode))
}
