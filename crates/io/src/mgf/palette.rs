//! The materials that surfaces use, each once.

use super::Material;
use super::draft::{Draft, Repairs};
use std::collections::HashMap;
use std::sync::Arc;

/// Finished materials.
#[derive(Default)]
pub(super) struct Palette {
    pub(super) materials: Vec<Material>,
    /// What each context was when a surface last used it, and as which material.
    last: HashMap<usize, (Draft, usize)>,
}

impl Palette {
    /// How much memory one more material takes: itself, its draft, and an entry.
    pub(super) const MEMORY: u64 = (size_of::<Material>() + 2 * size_of::<Draft>() + 64) as u64;

    /// The index of a material, by its context; with what had to be repaired if
    /// it is new.
    pub(super) fn index(
        &mut self,
        (slot, name, draft): (usize, &Arc<str>, &Draft),
    ) -> (usize, Repairs) {
        if let Some((_, index)) = self.last.get(&slot).filter(|(known, _)| known == draft) {
            return (*index, Repairs::default());
        }
        let (material, repairs) = draft.finish();
        let index = self.materials.len();
        self.materials.push(Material { name: Arc::clone(name), ..material });
        self.last.insert(slot, (draft.clone(), index));
        (index, repairs)
    }
}
