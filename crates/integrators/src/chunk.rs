//! A part of a pass, and what came of it.

use crate::Control;
use crate::FoundPath;
use crate::numbers::{Dimensions, PathSampler, PointSet, Purpose, RealNumbers, rotation};
use crate::tracer::{Statistics, Tracer};
use std::ops::Range;
use traylib_math::{Rgb, Vec2};
use traylib_scene::Scene;

/// Some pixels and some light paths of one pass.
#[derive(Clone, Debug)]
pub struct Chunk<'a> {
    /// Seed of the whole rendering.
    pub seed: u64,
    /// Number of the pass.
    pub pass: u64,
    /// Row-major indices of the pixels.
    pub pixels: Range<u32>,
    /// Numbers of the light paths within the pass.
    pub light_paths: Range<u32>,
    /// Light paths of the whole pass.
    pub light_path_count: u32,
    /// The source of its paths' numbers.
    pub points: PointSet,
    /// The numbers of a vertex that the scene uses.
    pub dimensions: Dimensions,
    /// Says whether it is still wanted.
    pub control: &'a Control,
}

impl Chunk<'_> {
    /// The random numbers of a pixel's camera path.
    pub fn camera_sampler(&self, pixel: u32) -> PathSampler {
        let Self { seed, pass, dimensions, .. } = *self;
        let free = Purpose::Camera.sampler(seed, pass, pixel);
        match self.points {
            PointSet::Independent => PathSampler::independent(free),
            PointSet::Sobol => {
                let real = RealNumbers::of_pixel(seed, pass, pixel, dimensions);
                PathSampler::quasi_random(free, real)
            }
        }
    }

    /// The random numbers of a light path.
    pub fn light_sampler(&self, path: u32) -> PathSampler {
        let Self { seed, pass, dimensions, light_path_count, .. } = *self;
        let free = Purpose::Light.sampler(seed, pass, path);
        match self.points {
            PointSet::Independent => PathSampler::independent(free),
            PointSet::Sobol => {
                let turned = (rotation(seed, pass, light_path_count), light_path_count);
                let real = RealNumbers::of_light_path(seed, pass, path, turned, dimensions);
                PathSampler::quasi_random(free, real)
            }
        }
    }

    /// Gives each pixel of the chunk one sample: `estimate` of a film point drawn
    /// uniformly in the pixel, with the random numbers of its path.
    pub fn sample_pixels(
        &self,
        scene: &Scene,
        out: &mut ChunkOutput,
        mut estimate: impl FnMut(&mut Tracer<'_>, Vec2, &mut PathSampler) -> Rgb,
    ) {
        self.sample_each_pixel(scene, out, |tracer, _, film_point, sampler| {
            estimate(tracer, film_point, sampler)
        });
    }

    /// Samples each pixel for an estimate that also wants the pixel's row-major index.
    pub(crate) fn sample_each_pixel(
        &self,
        scene: &Scene,
        out: &mut ChunkOutput,
        mut estimate: impl FnMut(&mut Tracer<'_>, u32, Vec2, &mut PathSampler) -> Rgb,
    ) {
        let mut tracer = Tracer::new(scene, self.control);
        for pixel in self.pixels.clone() {
            let mut sampler = self.camera_sampler(pixel);
            // Uniform in the pixel: the film has a box filter.
            let film_point = pixel_corner(scene, pixel) + sampler.pixel_point();
            let radiance = estimate(&mut tracer, pixel, film_point, &mut sampler);
            out.add(pixel, radiance);
        }
        out.statistics += tracer.statistics;
    }
}

/// The film point at the top left corner of a pixel with this row-major index.
pub fn pixel_corner(scene: &Scene, pixel: u32) -> Vec2 {
    let width = scene.camera().width();
    Vec2::new((pixel % width) as f32, (pixel / width) as f32)
}

/// The contribution of one chunk to its pass.
#[derive(Debug, Default)]
pub struct ChunkOutput {
    /// Radiance for pixels, in the order in which it was found.
    pub(crate) light: Vec<(u32, Rgb)>,
    /// Radiance for pixels of further pictures that a report asked for.
    pub(crate) layers: Vec<(u16, u32, Rgb)>,
    /// Text that a report asked for.
    pub(crate) notes: Vec<String>,
    /// Paths that a report asked for.
    pub(crate) paths: Vec<FoundPath>,
    /// Counters of the work.
    pub statistics: Statistics,
}

impl ChunkOutput {
    /// Adds radiance to a pixel. What is negative or not finite is counted and
    /// left out.
    pub fn add(&mut self, pixel: u32, radiance: Rgb) {
        if !radiance.is_finite() || radiance.min_band() < 0.0 {
            self.statistics.rejected += 1;
        } else if !radiance.is_black() {
            self.light.push((pixel, radiance));
        }
    }
}
