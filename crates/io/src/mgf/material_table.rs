//! The materials that surfaces use, each once.

use super::Material;
use super::material_builder::{MaterialBuilder, Repairs};
use std::collections::HashMap;
use std::sync::Arc;

/// Finished materials.
#[derive(Default)]
pub(super) struct MaterialTable {
    pub(super) materials: Vec<Material>,
    /// The state of each context when a surface last used it, and the material that it was then.
    last: HashMap<usize, (MaterialBuilder, usize)>,
}

impl MaterialTable {
    /// The memory that one more material takes, in bytes: itself, two builders, and an entry.
    pub(super) const MEMORY: u64 =
        (size_of::<Material>() + 2 * size_of::<MaterialBuilder>() + 64) as u64;

    /// The index of a material, by its context; with what had to be repaired if
    /// it is new.
    pub(super) fn index(
        &mut self,
        (slot, name, builder): (usize, &Arc<str>, &MaterialBuilder),
    ) -> (usize, Repairs) {
        if let Some((_, index)) = self.last.get(&slot).filter(|(known, _)| known == builder) {
            return (*index, Repairs::default());
        }
        let (material, repairs) = builder.finish();
        let index = self.materials.len();
        self.materials.push(Material { name: Arc::clone(name), ..material });
        self.last.insert(slot, (builder.clone(), index));
        (index, repairs)
    }
}
