//! Pictures on surfaces as EXR files, each once, however often it is used.

use crate::picture::encode_exr;
use std::collections::HashMap;
use std::sync::Arc;
use traylib_materials::Texture;

/// The pictures so far, by where they are in memory.
#[derive(Default)]
pub(super) struct Pictures(HashMap<*const Texture, usize>, Vec<Arc<Texture>>);

impl Pictures {
    /// The number of a picture, from 1.
    pub(super) fn number(&mut self, texture: &Arc<Texture>) -> usize {
        let next = self.1.len() + 1;
        let number = *self.0.entry(Arc::as_ptr(texture)).or_insert(next);
        if number == next {
            self.1.push(Arc::clone(texture));
        }
        number
    }

    /// All of them, the first of which has the number 1.
    pub(super) fn into_all(self) -> Vec<Arc<Texture>> {
        self.1
    }
}

/// The bytes of a file that reads back as this picture.
pub(super) fn encode(
    texture: &Texture,
) -> Result<Vec<u8>, Box<dyn std::error::Error + Send + Sync>> {
    encode_exr(texture.pixels())
}
