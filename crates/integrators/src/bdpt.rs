//! Bidirectional path tracing (sections 2.4 and 4 of the paper).
//!
//! A light subpath x₀ … and a camera subpath x_k … are walked independently. Every
//! pair of a prefix with s vertices of the one and t of the other is a path of
//! k = s + t − 1 edges, found by *technique* (s, t). All techniques that can find
//! a path share its light, by weights that sum to one.
//!
//! The paper gets its shorter paths "by leaving out steps" of longer ones; here
//! that means prefixes, whose densities are known. Leaving out inner vertices
//! would need a marginal density that nobody can evaluate.

mod auto;
mod connect;
mod connection_roulette;
mod direct_sum;
mod paths_per_pixel;
mod report;
mod settings;
mod subpath;
mod subset;
mod techniques;
mod vertex;
mod walk;
mod weight;

pub use auto::{Auto, MayLose};
pub use paths_per_pixel::PathsPerPixel;
pub use report::{Report, Technique};
pub use settings::BdptSettings;
pub use subset::TechniqueSet;
pub use techniques::{LightSampling, Techniques};

use crate::tracer::Tracer;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, Limits, SceneFacts};
use connect::Joiner;
use std::ops::Range;
use subpath::Subpath;
use traylib_math::Heuristic;
use traylib_scene::Scene;
use vertex::Vertex;
use walk::{LightStart, Walker};

/// The computation of the weights of multiple importance sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weighting {
    /// From two numbers carried along each subpath: a constant amount of work.
    #[default]
    Recursive,
    /// From the densities of every technique for the whole path: slow and plain,
    /// the standard the other is held to.
    DirectSum,
    /// The same, among these techniques alone.
    Among(TechniqueSet),
}

/// Bidirectional path tracing with any subset of its techniques.
#[derive(Clone, Debug)]
pub struct Bdpt {
    /// Bounds on the length of paths.
    pub limits: Limits,
    /// The heuristic that turns densities into weights.
    pub heuristic: Heuristic,
    /// Recursive or by direct sum.
    pub weighting: Weighting,
    /// The techniques that take part.
    pub techniques: Techniques,
    /// Light paths of a pass, for each of its pixels.
    pub light_paths: PathsPerPixel,
    /// True if walks from the camera aim at images of lamps in mirrors: see
    /// [`TowardLight`](crate::toolkit::TowardLight).
    pub aims_at_images: bool,
    /// The output to record beside the picture.
    pub report: Report,
}

impl Default for Bdpt {
    fn default() -> Self {
        BdptSettings::DEFAULT.integrator(Report::default())
    }
}

/// A light path: where it started, and the vertices after that.
#[derive(Clone, Copy)]
struct LightPath<'a> {
    start: &'a LightStart,
    vertices: &'a [Vertex],
}

/// The light paths of a chunk, their vertices in one list.
struct LightPaths {
    walks: Subpath,
    /// Start and vertices of each path; `None` for one that left the scene at
    /// once.
    paths: Vec<Option<(LightStart, Range<usize>)>>,
}

impl LightPaths {
    /// None yet, with room for so many of usual length: to copy vertices when a list
    /// grows would cost bdpt two instructions in a hundred.
    fn with_room(paths: usize) -> Self {
        const USUAL: usize = 6;
        let vertices = Vec::with_capacity(USUAL * paths);
        let walks = Subpath { vertices, ..Subpath::default() };
        Self { walks, paths: Vec::with_capacity(paths) }
    }

    /// The path that a camera path is joined with, by its place in the chunk.
    fn partner(&self, camera_path: usize) -> Option<LightPath<'_>> {
        // With fewer light paths than pixels, one is joined more than once.
        let index = camera_path.checked_rem(self.paths.len())?;
        let (start, range) = self.paths[index].as_ref()?;
        Some(LightPath { start, vertices: &self.walks.vertices[range.clone()] })
    }
}

impl Weighting {
    /// Tells whether technique (s, t) may add light.
    fn includes(self, s: usize, t: usize) -> bool {
        match self {
            Self::Recursive | Self::DirectSum => true,
            Self::Among(set) => set.contains(s, t),
        }
    }
}

impl Integrator for Bdpt {
    fn light_paths(&self, pixels: u32) -> u32 {
        // The shortest path that one takes part in has two edges.
        let are_used = self.techniques.need_light_paths() && self.limits.allow(2);
        if are_used { self.light_paths.over(pixels) } else { 0 }
    }

    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let pixels = scene.camera().width() * scene.camera().height();
        let light_paths = self.light_paths(pixels);
        let mut tracer = Tracer::new(scene, chunk.control);
        let splats_in_weights = weight::splats_in_weights(light_paths, chunk.points);
        let walker = Walker::new(self, splats_in_weights);
        let joiner = Joiner::new(self, light_paths, splats_in_weights);

        // Light walks first: each is splatted, and kept for the camera paths.
        let mut light = LightPaths::with_room(chunk.light_paths.len());
        for path in chunk.light_paths.clone() {
            let first = light.walks.vertices.len();
            let mut sampler = chunk.light_sampler(path);
            let start = walker.light_subpath(&mut tracer, &mut sampler, &mut light.walks);
            light.paths.push(start.map(|start| (start, first..light.walks.vertices.len())));
            if let Some(path) = light.partner(light.paths.len() - 1) {
                joiner.splat_all(&mut tracer, path, out);
            }
        }

        // Then a camera walk a pixel, joined with its partner among the light walks.
        let mut camera = Subpath::default();
        for (i, pixel) in chunk.pixels.clone().enumerate() {
            camera.clear();
            let mut sampler = chunk.camera_sampler(pixel);
            walker.camera_subpath(&mut tracer, pixel, &mut sampler, &mut camera);
            joiner.join_all(&mut tracer, pixel, &camera, light.partner(i), sampler.free(), out);
        }
        out.statistics += tracer.statistics;
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        let Techniques { splats, mirror_connections, .. } = self.techniques;
        if splats {
            facts.point_light_caustics_in_mirrors(mirror_connections)
        } else {
            facts.point_light_caustics(mirror_connections)
        }
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
pub(crate) use tests::room;
