//! Counts of everything in a file.

use super::Document;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// Counts of what was read, includes and arrays carried out and no shape cut up. Names of materials
/// count, not how often a name is given anew.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Surfaces.
    pub surfaces: u64,
    /// Surfaces, by keyword.
    pub by_kind: BTreeMap<&'static str, u64>,
    /// Surfaces that emit light.
    pub emitting_surfaces: u64,
    /// Surfaces that emit light, by keyword.
    pub emitting_by_kind: BTreeMap<&'static str, u64>,
    /// The materials of these, in the order of first use; `(unnamed)` for one
    /// without a name.
    pub emitting_material_names: Vec<String>,
    /// Definitions of materials.
    pub material_definitions: u64,
    /// Definitions of colours.
    pub color_definitions: u64,
    /// Definitions of vertices.
    pub vertex_definitions: u64,
    /// Materials that surfaces use.
    pub materials_used_by_geometry: u64,
    /// Materials that emitting surfaces use.
    pub emitting_materials_used: u64,
    /// Entities, by keyword. Comments and objects are left out, and each end of
    /// a copy counts as an `xf`.
    pub entities_after_include_and_array: BTreeMap<&'static str, u64>,
    /// Lines with an unknown first word, comments without a blank included.
    pub unknown_entities: u64,
}

impl Counts {
    /// Counts what is in the document.
    pub(super) fn add_surfaces(&mut self, document: &Document) {
        for surface in &document.surfaces {
            let keyword = surface.shape.keyword();
            self.surfaces += 1;
            *self.by_kind.entry(keyword).or_default() += 1;
            if document.materials[surface.material].emits() {
                self.emitting_surfaces += 1;
                *self.emitting_by_kind.entry(keyword).or_default() += 1;
            }
        }
        self.add_materials(document);
    }

    fn add_materials(&mut self, document: &Document) {
        // Equal names are one in memory, which is sooner told than by their letters.
        let (mut used, mut emitting) = (BTreeSet::new(), BTreeSet::new());
        for material in &document.materials {
            let name = &*material.name;
            used.insert(name.as_ptr());
            if material.emits() && emitting.insert(name.as_ptr()) {
                let shown = if name.is_empty() { "(unnamed)" } else { name };
                self.emitting_material_names.push(shown.to_string());
            }
        }
        self.materials_used_by_geometry = used.len() as u64;
        self.emitting_materials_used = emitting.len() as u64;
    }
}
