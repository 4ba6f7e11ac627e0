//! Surfaces that let light through and have one side.
//!
//! From behind they are not there, so that light goes out through them as if nothing
//! were in its way, and in through what they are. Paths from lamps and paths from the
//! camera cannot agree on that (`docs/conventions.md`, "Front sides"). A lamp with two
//! sides that emit is two such surfaces back to back, which together have both sides.

mod harmless;

use super::counter::Counter;
use super::imported_object::ImportedObject;
use super::model_part::ModelSide;
use crate::Warning;
use harmless::Surroundings;
pub(super) use harmless::is_closed_mesh;
use std::collections::BTreeMap;
use traylib_geometry::Sides;
use traylib_materials::{Material, SurfaceModel};
use traylib_math::{Rgb, Vec3};

/// An object with all that a warning says of it.
#[derive(Clone, Copy)]
pub(super) struct Described<'a> {
    pub(super) item: &'a ImportedObject,
    pub(super) material: &'a Material,
    /// The name of the material; it may be empty.
    pub(super) name: &'a str,
    /// The file that can be changed.
    pub(super) file: &'a str,
    /// The way to change it, in words.
    pub(super) remedy: &'a str,
}

/// One warning for each material of such a surface. `points` are the camera and the
/// lights that are no objects.
pub(super) fn warnings(items: &[Described<'_>], points: Vec<Vec3>) -> Vec<Warning> {
    let mut counters: BTreeMap<&str, Counter> = BTreeMap::new();
    let mut surroundings = Surroundings::new(items, points);
    for (index, item) in items.iter().enumerate() {
        if item.is_suspect() && !surroundings.is_harmless(index) {
            counters.entry(item.file).or_default().add(item.warning());
        }
    }
    counters.into_iter().flat_map(|(file, counter)| counter.into_warnings(file)).collect()
}

impl Described<'_> {
    fn is_suspect(&self) -> bool {
        let is_alone = self.item.sides == Sides::Front && self.item.side == ModelSide::Whole;
        is_alone && lets_light_through(self.material)
    }

    fn warning(&self) -> String {
        let name = self.name;
        let what = if name.is_empty() { String::new() } else { format!(" `{name}`") };
        format!(
            "material{what} lets light through and has one side, which programs that start at \
             lamps see otherwise than those that start at the camera: {}",
            self.remedy
        )
    }
}

/// Straight, scattered or refracted.
fn lets_light_through(material: &Material) -> bool {
    !material.through.is_black() || material.has_opacity() || bends_or_scatters(&material.model)
}

fn bends_or_scatters(model: &SurfaceModel) -> bool {
    matches!(model, SurfaceModel::Dielectric(_)) || !scattered(model).is_black()
}

/// Returns the BSDF for light that goes straight on, where a sheet's lobe is highest.
fn scattered(model: &SurfaceModel) -> Rgb {
    if model.transmits() { model.evaluate(Vec3::Z, Vec3::Z, Vec3::NEG_Z).f } else { Rgb::BLACK }
}
