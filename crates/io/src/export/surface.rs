//! Materials as they stand in scene files.

use super::number::{colour, number, quoted, tuple};
use super::picture::Pictures;
use std::fmt::Write;
use traylib_materials::{Bump, Layer, Maps, Material, Phong, SurfaceModel, Tiling};
use traylib_math::glam::Affine2;
use traylib_math::{Rgb, Vec2};

/// A material in RON; its pictures are in `folder`.
pub(super) fn material(material: &Material, folder: &str, pictures: &mut Pictures) -> String {
    let plain = with_pass_through(&material.model, material.through);
    match &material.maps {
        None => plain,
        Some(maps) => textured(&plain, maps, folder, pictures),
    }
}

fn with_pass_through(model: &SurfaceModel, through: Rgb) -> String {
    if through.is_black() {
        return scattering(model);
    }
    let through = colour(through);
    match model {
        SurfaceModel::Mirror(m) if m.diffuse().is_black() => {
            format!("Pane(reflectance: {}, through: {through})", colour(m.reflectance()))
        }
        SurfaceModel::Lambert(_)
        | SurfaceModel::Phong(_)
        | SurfaceModel::MaxPhong(_)
        | SurfaceModel::Mirror(_)
        | SurfaceModel::Sheet(_)
        | SurfaceModel::Dielectric(_) => {
            format!("Gauze(base: {}, through: {through})", scattering(model))
        }
    }
}

fn scattering(model: &SurfaceModel) -> String {
    match model {
        SurfaceModel::Lambert(m) => format!("Lambert(reflectance: {})", colour(m.reflectance())),
        SurfaceModel::Phong(m) => format!("Phong{}", lobes(m)),
        SurfaceModel::MaxPhong(m) => {
            format!(
                "MaxPhong(specular: {}, exponent: {})",
                colour(m.specular()),
                number(m.exponent())
            )
        }
        SurfaceModel::Mirror(m) => format!(
            "Mirror(reflectance: {}, diffuse: {})",
            colour(m.reflectance()),
            colour(m.diffuse())
        ),
        SurfaceModel::Sheet(m) => format!(
            "Sheet(reflection: {}, transmission: {})",
            lobes(&m.reflection()),
            lobes(&m.transmission())
        ),
        SurfaceModel::Dielectric(m) => format!("Glass(index: {})", number(m.index())),
    }
}

fn lobes(phong: &Phong) -> String {
    let [diffuse, specular] = [phong.diffuse(), phong.specular()].map(colour);
    format!("(diffuse: {diffuse}, specular: {specular}, exponent: {})", number(phong.exponent()))
}

fn textured(base: &str, maps: &Maps, folder: &str, pictures: &mut Pictures) -> String {
    let Maps { diffuse, specular, opacity, bump } = maps;
    let mut text = format!("Textured(base: {base}");
    for (name, layer) in [("diffuse", diffuse), ("specular", specular), ("opacity", opacity)] {
        if let Some(layer) = layer {
            let strength = match layer.strength {
                1.0 => String::new(),
                strength => format!(", strength: {}", number(strength)),
            };
            _ = write!(text, ", {name}: ({}{strength})", lay(layer, folder, pictures));
        }
    }
    if let Some(Bump { layer, height }) = bump {
        let lay = lay(layer, folder, pictures);
        _ = write!(text, ", bump: ({lay}, height: {})", number(*height));
    }
    text + ")"
}

/// A picture and the way it lies on a surface.
fn lay(layer: &Layer, folder: &str, pictures: &mut Pictures) -> String {
    let number = pictures.number(&layer.texture);
    let mut text = format!("file: {}", quoted(&format!("{folder}/picture-{number}.exr")));
    match layer.tiling {
        Tiling::Repeat => {}
        Tiling::Mirror => text += ", tiling: Mirror",
        Tiling::Once => text += ", tiling: Once",
    }
    let Affine2 { matrix2, translation } = layer.placement;
    let [x, y] = [matrix2.x_axis, matrix2.y_axis];
    if layer.placement == Affine2::IDENTITY {
        text
    } else if translation == Vec2::ZERO && x.y == 0.0 && y.x == 0.0 {
        text + &format!(", scale: {}", tuple(&[x.x, y.y]))
    } else {
        text + &format!(", matrix: {}", tuple(&[x.x, x.y, y.x, y.y, translation.x, translation.y]))
    }
}
