//! One ray a pixel, light from point lights alone (section 3.2 of the paper).

use crate::chunk::pixel_corner;
use crate::direct::sample_point_lights;
use crate::tracer::Tracer;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use traylib_geometry::Ray;
use traylib_math::{Rgb, Vec2, Vec3};
use traylib_scene::{MAX_PASS_THROUGHS, Scene, SurfacePoint};

/// Emission seen directly, the sky's too, and one shadow ray to each point light; no other
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
        if facts.sky {
            blind.push(BlindSpot::SkyLight);
        }
        blind
    }
}

/// The path of a pixel, as far as it has been followed.
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
    for _ in 0..MAX_PASS_THROUGHS {
        // What stands next in each path, and what point lights give it.
        let rays: Vec<Ray> = going.iter().map(|&index| paths[index].ray).collect();
        let mut sights = look(tracer, &rays).into_iter();
        going.retain(|&index| {
            let Some(Some(sight)) = sights.next() else { return false };
            paths[index].pass(&sight)
        });
        if going.is_empty() {
            break;
        }
    }
    paths
}

/// The surface that a ray has met: as much of a surface as is needed later. A list of whole
/// surfaces would not fit into the nearest cache.
struct Sight {
    emitted: Rgb,
    /// The radiance of point lights that it reflects.
    lit: Rgb,
    opacity: f32,
    through: Rgb,
    /// The origin of the ray that goes on.
    origin: Vec3,
}

/// Finds the surface that each ray meets, lit by all point lights, whose shadow rays are asked
/// together; nothing of rays beyond the end of the list.
fn look(tracer: &mut Tracer<'_>, rays: &[Ray]) -> Vec<Option<Sight>> {
    let scene = tracer.scene;
    let (mut segments, mut samples) = (Vec::new(), Vec::new());
    let mut see = |(index, (ray, point)): (usize, (&Ray, Option<SurfacePoint>))| {
        let Some(point) = point else { return Sight::of_sky(scene, ray) };
        for sample in sample_point_lights(scene, &point, -ray.direction) {
            segments.push(sample.x0.segment_from(&point.site));
            samples.push((index, sample.radiance));
        }
        Some(Sight {
            emitted: scene.emitted(&point),
            lit: Rgb::BLACK,
            opacity: point.opacity,
            through: point.through,
            origin: point.site.ray_origin(ray.direction),
        })
    };
    let met = rays.iter().zip(tracer.intersect_each(rays)).enumerate();
    let mut sights: Vec<Option<Sight>> = met.map(&mut see).collect();
    for ((index, radiance), transmittance) in samples.into_iter().zip(tracer.sees_each(&segments)) {
        if !transmittance.is_black()
            && let Some(sight) = &mut sights[index]
        {
            sight.lit += radiance * transmittance;
        }
    }
    sights
}

impl Sight {
    /// The sky behind all surfaces, if there is one.
    #[cold]
    fn of_sky(scene: &Scene, ray: &Ray) -> Option<Self> {
        let emitted = scene.sky()?.radiance(ray.direction);
        let (lit, through, origin) = (Rgb::BLACK, Rgb::BLACK, ray.origin);
        Some(Self { emitted, lit, opacity: 1.0, through, origin })
    }
}

impl PixelPath {
    /// Adds what the surface shows, and goes on behind it; whether there is anything left.
    fn pass(&mut self, sight: &Sight) -> bool {
        let light = sight.emitted + sight.lit;
        self.radiance += self.transmittance * light * sight.opacity;
        self.transmittance *= sight.through;
        self.ray.origin = sight.origin;
        !self.transmittance.is_black()
    }
}
