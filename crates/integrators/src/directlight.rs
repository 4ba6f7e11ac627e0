//! Lamps sampled at every vertex (sections 2.2 and 2.3 of the paper).

mod pixel;

use crate::direct::{LightSample, sample_light};
use crate::mirrored_point::light_through_mirrors;
use crate::numbers::PathSampler;
use crate::step::next_step_toward_light;
use crate::toward_light::{TowardLight, images_for};
use crate::tracer::{SurfaceHit, Tracer};
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, Limits, SceneFacts};
pub(crate) use pixel::DirectLightOfPixel;
use pixel::{PathNotes, Way};
use traylib_geometry::Ray;
use traylib_math::{Heuristic, Rgb, SolidAnglePdf, Vec3, solid_angle_per_area};
use traylib_scene::{Scene, SurfacePoint, Walk};

/// Walks from the camera and aims at a lamp from every vertex.
///
/// Strictly, a lamp that the walk hits by itself counts only where no light
/// sample could have been drawn: seen directly, or after a perfect mirror. (The
/// paper does not count it there either, which leaves lamps black in mirrors.)
/// With `combine`, both ways count everywhere, weighted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DirectLight {
    /// The limits of the lengths of paths.
    pub limits: Limits,
    /// Combine light sampling with hits by this heuristic.
    pub combine: Option<Heuristic>,
    /// Do not look for images of lamps in mirrors: neither aim at those of small ones nor join
    /// those of point lights.
    pub no_images: bool,
}

impl Default for DirectLight {
    fn default() -> Self {
        Self { limits: Limits::OF_CAMERA_WALKS, combine: None, no_images: false }
    }
}

/// The technique by which the walk came to its vertex.
#[derive(Clone, Copy)]
enum Arrival {
    /// From the camera or a perfect mirror: no light sample competes.
    Alone,
    /// From a surface at this place, drawn with this density.
    Sampled(Vec3, SolidAnglePdf),
}

impl Integrator for DirectLight {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        chunk.sample_pixels(scene, out, |tracer, film_point, sampler| {
            self.radiance(tracer, scene.camera().ray(film_point), sampler, None)
        });
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        facts.point_light_caustics(!self.no_images)
    }
}

impl DirectLight {
    /// Estimates the radiance that arrives over a ray from the camera; each path may be noted.
    fn radiance(
        &self,
        tracer: &mut Tracer<'_>,
        mut ray: Ray,
        sampler: &mut PathSampler,
        mut notes: Option<&mut PathNotes>,
    ) -> Rgb {
        let scene = tracer.scene;
        let mut radiance = Rgb::BLACK;
        let mut throughput = Rgb::WHITE;
        let mut arrival = Arrival::Alone;
        // Images of large lamps are hit without aiming.
        let aims = !self.no_images && scene.lights_are_small();
        // Those of points cannot be hit.
        let joins = !self.no_images && scene.has_point_images();
        for edges in 1.. {
            // The next vertex, and what the edge to it lets through.
            let numbers = sampler.vertex();
            let hit = tracer.edge_from_camera(edges, &ray, numbers.pass_through);
            let Some(SurfaceHit { point, transmittance }) = &hit else { break };
            throughput *= *transmittance;
            let wo = -ray.direction;
            // A lamp that the walk hit: s = 0.
            let (emitted, weight) = self.hit_emission(scene, point, wo, arrival);
            radiance += throughput * (emitted * weight);
            if let Some(notes) = notes.as_deref_mut() {
                notes.came_to(point.site.position);
                notes.found(Way::Hit, throughput * emitted, weight);
            }
            if !self.limits.allow(edges + 1) {
                break;
            }
            // How the walk looks for light from here.
            let images = if aims { images_for(scene, point) } else { None };
            let toward_light = TowardLight::of(images.as_ref());
            // A point of a lamp that is aimed at: s = 1.
            if let Some(mut light) = sample_light(scene, point, wo, &numbers)
                && let Some(transmittance) = light.visible(tracer, point)
            {
                light.mix(toward_light, point);
                let weight = self.light_weight(&light);
                let value = throughput * light.radiance * transmittance;
                radiance += value * weight;
                if let Some(notes) = notes.as_deref_mut() {
                    notes.found(Way::LightSample(light.x0.site.position), value, weight);
                }
            }
            // Point lights by way of a mirror, which no walk from the camera finds.
            if joins {
                let room = (edges, self.limits);
                let value = throughput * light_through_mirrors(tracer, point, wo, &numbers, room);
                radiance += value;
                if let Some(notes) = notes.as_deref_mut() {
                    notes.found(Way::Mirrors, value, 1.0);
                }
            }
            // On in that way, if roulette lets it.
            let roulette = self.limits.roulette;
            let (walk, edge) = (Walk::FromCamera, edges + 1);
            let step =
                next_step_toward_light(walk, toward_light, point, wo, &numbers, roulette, edge);
            let Some(step) = step else { break };
            throughput *= step.weight;
            // Where the next hit could have been aimed at from, and with what density.
            arrival = if step.sample.is_delta {
                Arrival::Alone
            } else {
                Arrival::Sampled(point.site.position, step.sample.pdf)
            };
            ray = step.ray;
        }
        radiance
    }

    /// Emission of a lamp that the walk hit, and the weight of having hit it.
    fn hit_emission(
        &self,
        scene: &Scene,
        point: &SurfacePoint,
        wo: Vec3,
        arrival: Arrival,
    ) -> (Rgb, f32) {
        // Only the front of a lamp shines.
        let Some((id, x0)) = scene.emitting_point(point) else { return (Rgb::BLACK, 0.0) };
        let weight = match (arrival, self.combine) {
            (Arrival::Alone, _) => 1.0,
            (Arrival::Sampled(..), None) => 0.0,
            (Arrival::Sampled(from, pdf), Some(heuristic)) => {
                // Both densities per area of the lamp, at the point that was hit.
                let conversion = solid_angle_per_area(x0.cosine(wo), x0.distance_squared(from));
                let toward = scene.toward_density(id, &x0, from);
                heuristic.weight(pdf.to_area(conversion).0, toward)
            }
        };
        (x0.emitted, weight)
    }

    /// The weight of a light sample against hitting the same point.
    fn light_weight(&self, light: &LightSample) -> f32 {
        self.combine.map_or(1.0, |heuristic| {
            // The same two densities, of a point that was aimed at.
            heuristic.weight(light.toward, light.hit_pdf())
        })
    }
}
