//! Surfaces that let light through and have one side.
//!
//! From behind they are not there, so that light goes out through them as if nothing
//! were in its way, and in through what they are. Paths from lamps and paths from the
//! camera cannot agree on that (`docs/conventions.md`, "Front sides"). A lamp with two
//! sides that emit is two such surfaces back to back, which together have both sides.

use super::model::Half;
use super::thing::Thing;
use traylib_geometry::Sides;
use traylib_materials::{Material, SurfaceModel};
use traylib_math::{Rgb, Vec3};

/// What there is to say of a thing of this material, whose name is empty if it has none.
pub(super) fn warning(
    thing: &Thing,
    material: &Material,
    name: &str,
    remedy: &str,
) -> Option<String> {
    let is_alone = thing.sides == Sides::Front && thing.half == Half::Whole;
    if !is_alone || !lets_light_through(material) {
        return None;
    }
    let what = if name.is_empty() { String::new() } else { format!(" `{name}`") };
    Some(format!(
        "material{what} lets light through and has one side, which programs that start at \
         lamps see otherwise than those that start at the camera: {remedy}"
    ))
}

/// Straight, scattered or refracted.
fn lets_light_through(material: &Material) -> bool {
    let straight = !material.through.is_black() || material.has_opacity();
    straight || refracts(&material.model) || !scattered(&material.model).is_black()
}

fn refracts(model: &SurfaceModel) -> bool {
    matches!(model, SurfaceModel::Dielectric(_))
}

/// What goes on straight, where a sheet's lobe is highest.
fn scattered(model: &SurfaceModel) -> Rgb {
    if model.transmits() { model.evaluate(Vec3::Z, Vec3::Z, Vec3::NEG_Z).f } else { Rgb::BLACK }
}
