//! One ray a pixel, light from point lights alone (section 3.2 of the paper).

use crate::chunk::pixel_corner;
use crate::direct::sample_point_lights;
use crate::tracer::Tracer;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use traylib_math::{Rgb, Vec2};
use traylib_scene::{MOST_PASSAGES, Scene};

/// Emission seen directly, and one shadow ray to each point light; no other
/// light, no interreflection. Without `jitter` the ray goes through the middle
/// of the pixel and nothing is random.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trace {
    /// Draw the film point uniformly in its pixel, for pictures of several
    /// samples.
    pub jitter: bool,
}

impl Integrator for Trace {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let mut tracer = Tracer::new(scene, chunk.control);
        for pixel in chunk.pixels.clone() {
            let inside =
                if self.jitter { chunk.camera_sampler(pixel).next_2d() } else { Vec2::splat(0.5) };
            out.add(pixel, radiance(&mut tracer, pixel_corner(scene, pixel) + inside));
        }
        out.statistics += tracer.statistics;
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        let mut blind = vec![BlindSpot::Interreflection];
        if facts.area_lights {
            blind.push(BlindSpot::AreaLights);
        }
        blind
    }
}

/// Light that comes straight through surfaces is followed, without chance.
fn radiance(tracer: &mut Tracer<'_>, film_point: Vec2) -> Rgb {
    let scene = tracer.scene;
    let mut ray = scene.camera().ray(film_point);
    tracer.statistics.camera_paths += 1;
    let (mut radiance, mut transmittance) = (Rgb::BLACK, Rgb::WHITE);
    for _ in 0..MOST_PASSAGES {
        // What stands next in the way.
        let Some(point) = tracer.look(&ray) else { break };
        let lit = sample_point_lights(scene, &point, -ray.direction)
            .filter_map(|sample| Some(sample.radiance * sample.visible(tracer, &point)?))
            .sum::<Rgb>();
        // As much of its light as there is of it.
        radiance += transmittance * (scene.emitted(&point) + lit) * point.opacity;
        // And straight on with the rest.
        transmittance *= point.through;
        if transmittance.is_black() {
            break;
        }
        ray.origin = point.site.ray_origin(ray.direction);
    }
    radiance
}
