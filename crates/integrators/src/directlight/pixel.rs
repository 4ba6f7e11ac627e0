//! Runs the same algorithm, and tells what one pixel is made of.

use super::DirectLight;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use std::fmt::Write;
use traylib_math::{Rgb, Vec3};
use traylib_scene::Scene;

/// [`DirectLight`] that notes all paths that add to one pixel, as text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DirectLightOfPixel {
    pub(crate) own: DirectLight,
    /// The pixel's row-major index.
    pub(crate) pixel: u32,
}

impl Integrator for DirectLightOfPixel {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let mut noted = Vec::new();
        chunk.sample_each_pixel(scene, out, |tracer, pixel, film_point, sampler| {
            let mut notes = (pixel == self.pixel).then(PathNotes::default);
            let ray = scene.camera().ray(film_point);
            let radiance = self.own.radiance(tracer, ray, sampler, notes.as_mut());
            noted.extend(notes.map_or_else(Vec::new, |notes| notes.paths));
            radiance
        });
        out.notes.append(&mut noted);
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        self.own.blind_spots(facts)
    }
}

/// The way in which a walk from the camera found light at its last vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Way {
    /// s = 0: the vertex is on a lamp.
    Hit,
    /// s = 1: a point of a lamp, here, was aimed at.
    LightSample(Vec3),
    /// s = 2: point lights were joined by way of mirrors.
    Mirrors,
}

/// The paths of one walk from the camera, as text.
#[derive(Debug, Default)]
pub(super) struct PathNotes {
    vertices: Vec<Vec3>,
    paths: Vec<String>,
}

impl PathNotes {
    /// The walk came to a place.
    pub(super) fn came_to(&mut self, place: Vec3) {
        self.vertices.push(place);
    }

    /// It found light there: `value` is what this way alone would add.
    pub(super) fn found(&mut self, way: Way, value: Rgb, weight: f32) {
        if value.is_black() {
            return;
        }
        let t = self.vertices.len() + 1;
        let (s, name, mut places) = match way {
            Way::Hit => (0, "", vec![]),
            Way::LightSample(place) => (1, "", vec![place.to_string()]),
            Way::Mirrors => {
                let places = ["point lights", "their images in mirrors"].map(String::from);
                (2, ", by way of a mirror", places.to_vec())
            }
        };
        // From the lamp to the camera.
        places.extend(self.vertices.iter().rev().map(Vec3::to_string));
        places.push(String::from("camera"));
        let Rgb { r, g, b } = value;
        let mut text =
            format!("(s={s}, t={t}{name})  value {r:.6e} {g:.6e} {b:.6e}  weight {weight:.6}\n");
        for (i, place) in places.iter().enumerate() {
            // Writing to a string does not fail.
            let _ = writeln!(text, "  x{i}  {place}");
        }
        self.paths.push(text);
    }
}
