//! The material of shapes that have none.

use crate::import::imported_material::ImportedMaterial;
use traylib_geometry::Sides;
use traylib_materials::{Error, Lambert, SurfaceModel};
use traylib_math::Rgb;

/// The reflectance of the grey material.
pub(super) const GREY: f32 = 0.5;

/// Makes a grey material of two sides.
///
/// # Errors
/// There are none: grey is a colour.
pub(super) fn material(name: &str) -> Result<ImportedMaterial, Error> {
    let surface = SurfaceModel::Lambert(Lambert::new(Rgb::splat(GREY))?).into();
    let name = name.to_string();
    Ok(ImportedMaterial { name, surface, sides: Sides::Both, emission: Rgb::BLACK })
}
