//! One ray a pixel, light from point lights alone (section 3.2 of the paper).

use crate::chunk::pixel_corner;
use crate::direct::sample_point_lights;
use crate::tracer::Tracer;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use traylib_geometry::Ray;
use traylib_math::{Rgb, Vec2};
use traylib_scene::{MOST_PASSAGES, Scene, SurfacePoint};

/// Emission seen directly, and one shadow ray to each point light; no other
/// light, no interreflection. Without `jitter` the ray goes through the middle
/// of the pixel and nothing is random.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// Draw the film point uniformly in its pixel, for pictures of several
    /// samples.
    pub jitter: bool,
}

impl Integrator for Trace {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let mut tracer = Tracer::new(scene, chunk.control);
        let ray = |pixel| {
            let inside = if self.jitter {
                chunk.camera_sampler(pixel).pixel_point()
            } else {
                Vec2::splat(0.5)
            };
            scene.camera().ray(pixel_corner(scene, pixel) + inside)
        };
        let paths = chunk.pixels.clone().map(|pixel| PixelPath {
            pixel,
            ray: ray(pixel),
            transmittance: Rgb::WHITE,
            radiance: Rgb::BLACK,
        });
        tracer.statistics.camera_paths += paths.len() as u64;
        for path in follow(&mut tracer, paths.collect()) {
            out.add(path.pixel, path.radiance);
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

/// What a pixel sees, as far as it has been followed.
struct PixelPath {
    pixel: u32,
    ray: Ray,
    /// The transmittance of all that it has passed.
    transmittance: Rgb,
    radiance: Rgb,
}

/// Follows all to the first surface that lets nothing through, surface by surface and
/// all at once, without chance.
fn follow(tracer: &mut Tracer<'_>, mut paths: Vec<PixelPath>) -> Vec<PixelPath> {
    let mut going: Vec<usize> = (0..paths.len()).collect();
    for _ in 0..MOST_PASSAGES {
        // What stands next in each path, and what point lights give it.
        let rays: Vec<Ray> = going.iter().map(|&index| paths[index].ray).collect();
        let points = tracer.intersect_each(&rays);
        let lit = lit_by_points(tracer, &rays, &points);
        let mut found = points.into_iter().zip(lit);
        going.retain(|&index| {
            let Some((Some(point), lit)) = found.next() else { return false };
            paths[index].pass(tracer.scene, &point, lit)
        });
        if going.is_empty() {
            break;
        }
    }
    paths
}

/// The radiance of each point toward its ray from all point lights, whose shadow rays are
/// asked together.
fn lit_by_points(
    tracer: &mut Tracer<'_>,
    rays: &[Ray],
    points: &[Option<SurfacePoint>],
) -> Vec<Rgb> {
    let scene = tracer.scene;
    let (mut segments, mut samples) = (Vec::new(), Vec::new());
    for (index, (ray, point)) in rays.iter().zip(points).enumerate() {
        let Some(point) = point else { continue };
        for sample in sample_point_lights(scene, point, -ray.direction) {
            segments.push(sample.x0.segment_from(&point.site));
            samples.push((index, sample.radiance));
        }
    }
    let mut lit = vec![Rgb::BLACK; points.len()];
    for ((index, radiance), transmittance) in samples.into_iter().zip(tracer.sees_each(&segments)) {
        if !transmittance.is_black() {
            lit[index] += radiance * transmittance;
        }
    }
    lit
}

impl PixelPath {
    /// Adds what the surface shows, and goes on behind it; whether there is anything left.
    fn pass(&mut self, scene: &Scene, point: &SurfacePoint, lit: Rgb) -> bool {
        self.radiance += self.transmittance * (scene.emitted(point) + lit) * point.opacity;
        self.transmittance *= point.through;
        self.ray.origin = point.site.ray_origin(self.ray.direction);
        !self.transmittance.is_black()
    }
}
