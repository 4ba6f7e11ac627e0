//! Pure Monte Carlo path tracing (section 2.1 of the paper).

use crate::direct::sample_point_light;
use crate::numbers::PathSampler;
use crate::step::next_step;
use crate::tracer::{SurfaceHit, Tracer};
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, Limits, SceneFacts};
use traylib_geometry::Ray;
use traylib_math::Rgb;
use traylib_scene::{Scene, Walk};

/// Walks from the camera and adds what the walk happens to hit.
///
/// Point lights cannot be hit; they are sampled at every vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PureMc {
    /// Bounds on the length of paths.
    pub limits: Limits,
}

impl Default for PureMc {
    fn default() -> Self {
        Self { limits: Limits::OF_CAMERA_WALKS }
    }
}

impl Integrator for PureMc {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        chunk.sample_pixels(scene, out, |tracer, film_point, sampler| {
            self.radiance(tracer, scene.camera().ray(film_point), sampler)
        });
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        facts.point_light_caustics(false)
    }
}

impl PureMc {
    fn radiance(&self, tracer: &mut Tracer<'_>, mut ray: Ray, sampler: &mut PathSampler) -> Rgb {
        let scene = tracer.scene;
        let mut radiance = Rgb::BLACK;
        let mut throughput = Rgb::WHITE;
        let has_points = scene.has_point_lights();
        for edges in 1.. {
            // The next vertex, and what the edge to it lets through.
            let numbers = sampler.vertex();
            let hit = tracer.edge_from_camera(edges, &ray, numbers.pass_through);
            let Some(SurfaceHit { point, transmittance }) = &hit else { break };
            throughput *= *transmittance;
            let wo = -ray.direction;
            // What the walk happens to hit.
            radiance += throughput * scene.emitted(point);
            if !self.limits.allow(edges + 1) {
                break;
            }
            // Point lights alone: lamps with an area are hit.
            if has_points
                && let Some(light) = sample_point_light(scene, point, wo, &numbers)
                && let Some(transmittance) = light.visible(tracer, point)
            {
                radiance += throughput * light.radiance * transmittance;
            }
            // On by the surface's own sampling, if roulette lets it.
            let roulette = self.limits.roulette;
            let step = next_step(Walk::FromCamera, point, wo, &numbers, roulette, edges + 1);
            let Some(step) = step else { break };
            throughput *= step.weight;
            ray = step.ray;
        }
        radiance
    }
}
