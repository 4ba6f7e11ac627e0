//! The pictures that materials of a file name.

use crate::import::counter::Counter;
use crate::import::textures::{Textures, Usage};
use crate::source::Location;
use std::sync::Arc;
use traylib_materials::Texture;

/// Loads the pictures of a file, and counts what it does without.
pub(super) struct Pictures<'a> {
    pub(super) textures: &'a mut Textures,
    pub(super) counter: &'a mut Counter,
}

impl Pictures<'_> {
    /// Loads the picture that a file calls `name`, from where it was found.
    pub(super) fn load(
        &mut self,
        name: &str,
        found: Option<Location>,
        usage: Usage,
    ) -> Option<Arc<Texture>> {
        let loaded = match found {
            Some(location) => self.textures.load(&location, usage),
            None if climbs(name) => Err(format!(
                "picture `{name}` not found, shown without: folders above the model's own are \
                 looked into if `--root` names one around them"
            )),
            None => Err(format!("picture `{name}` not found, shown without")),
        };
        self.counted(loaded)
    }

    /// Returns the picture, or counts why there is none.
    pub(super) fn counted(&mut self, loaded: Result<Arc<Texture>, String>) -> Option<Arc<Texture>> {
        loaded.map_err(|cause| self.counter.add(cause)).ok()
    }
}

/// Tells whether a name leads out of a folder.
fn climbs(name: &str) -> bool {
    name.split(['/', '\\']).any(|part| part == "..")
}
