//! The particle tracer: light paths alone.

use crate::emission::emit;
use crate::numbers::PathSampler;
use crate::splat::aim_at_camera;
use crate::step::next_step;
use crate::tracer::{SurfaceHit, Tracer};
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, Limits, SceneFacts};
use traylib_math::Rgb;
use traylib_scene::{Scene, Walk};

/// Walks from the lamps; every vertex that the camera sees is splatted into the
/// pixel it appears in. Lamps seen directly come from a camera ray a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Particle {
    /// Bounds on the length of paths.
    pub limits: Limits,
}

impl Integrator for Particle {
    fn light_paths(&self, pixels: u32) -> u32 {
        pixels
    }

    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        chunk.sample_pixels(scene, out, |tracer, film_point, sampler| {
            let pass_through = sampler.vertex().pass_through;
            tracer
                .camera_ray(&scene.camera().ray(film_point), pass_through)
                .map_or(Rgb::BLACK, |SurfaceHit { point, transmittance }| {
                    transmittance * scene.emitted(&point)
                })
        });
        // Then the light walks, whose light may land on any pixel.
        let mut tracer = Tracer::new(scene, chunk.control);
        // Each light path stands for as much of the power as one pixel is of the film.
        let share = 1.0 / (scene.camera().width() * scene.camera().height()) as f32;
        for path in chunk.light_paths.clone() {
            self.trace_light_path(&mut tracer, share, &mut chunk.light_sampler(path), out);
        }
        out.statistics += tracer.statistics;
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        if facts.mirrors { vec![BlindSpot::SeenInMirrors] } else { Vec::new() }
    }
}

impl Particle {
    /// Traces one light path, which carries `share` of the lamps' power.
    fn trace_light_path(
        &self,
        tracer: &mut Tracer<'_>,
        share: f32,
        sampler: &mut PathSampler,
        out: &mut ChunkOutput,
    ) {
        let scene = tracer.scene;
        let Some(start) = emit(tracer, sampler) else { return };
        let mut throughput = start.throughput * share;
        let (mut wo, mut point, mut numbers) = (-start.direction, start.x1, start.numbers);
        for edges in 1.. {
            if !self.limits.allow(edges + 1) {
                return;
            }
            // What this vertex sends into the camera.
            if let Some(splat) = aim_at_camera(scene, &point, wo)
                && let Some(transmittance) = tracer.seen_by_camera(&point)
            {
                out.add(splat.pixel(scene), throughput * splat.value * transmittance);
            }
            // On to the next vertex.
            let roulette = self.limits.roulette;
            let step = next_step(Walk::FromLight, &point, wo, &numbers, roulette, edges + 1);
            let Some(step) = step else { return };
            wo = -step.ray.direction;
            numbers = sampler.vertex();
            let Some(hit) = tracer.bounce_ray(&step.ray, numbers.pass_through) else { return };
            throughput *= step.weight * hit.transmittance;
            point = hit.point;
        }
    }
}
