//! A walk and what it found.

use super::vertex::Vertex;
use crate::toward_light::{TowardLight, images_for};
use traylib_scene::{ImageDirections, Scene};

/// The vertices of one walk, or of many in a row.
#[derive(Debug, Default)]
pub(crate) struct Subpath {
    pub(crate) vertices: Vec<Vertex>,
    /// The images of those vertices of camera paths that aim at some.
    pub(crate) images: Vec<ImageDirections>,
}

impl Subpath {
    pub(crate) fn clear(&mut self) {
        self.vertices.clear();
        self.images.clear();
    }

    /// Looks for images that the last vertex may aim at.
    pub(crate) fn aim(&mut self, scene: &Scene) {
        let Some(last) = self.vertices.last_mut() else { return };
        if let Some(images) = images_for(scene, &last.point) {
            last.images = Some(self.images.len() as u32);
            self.images.push(images);
        }
    }

    /// Returns how a walk from the camera chooses the direction in which it goes on from one of its
    /// vertices.
    #[inline]
    pub(crate) fn toward_light(&self, vertex: &Vertex) -> TowardLight<'_> {
        TowardLight::of(vertex.images.and_then(|index| self.images.get(index as usize)))
    }
}
