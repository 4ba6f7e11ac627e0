//! The two walks.

use super::subpath::Subpath;
use super::vertex::{SubpathState, Vertex};
use super::{Bdpt, Techniques};
use crate::Limits;
use crate::chunk::pixel_corner;
use crate::emission::{Emitted, emit};
use crate::mirrored_point::walked_by_mirror;
use crate::numbers::PathSampler;
use crate::step::next_step_toward_light;
use crate::toward_light::{TowardLight, images_for};
use crate::tracer::{SurfaceHit, Tracer};
use traylib_materials::BsdfSample;
use traylib_math::{Heuristic, SolidAnglePdf};
use traylib_scene::{LightDensities, LightId, LightPoint, Scene, SurfacePoint, Walk};

/// The start x₀ of a light subpath.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightStart {
    pub(crate) light: LightId,
    pub(crate) x0: LightPoint,
    pub(crate) densities: LightDensities,
}

/// Walks subpaths from either end.
pub(crate) struct Walker {
    limits: Limits,
    heuristic: Heuristic,
    techniques: Techniques,
    splats_in_weights: f64,
    aims_at_images: bool,
}

impl Walker {
    pub(crate) fn new(bdpt: &Bdpt, splats_in_weights: f64) -> Self {
        let Bdpt { limits, heuristic, techniques, aims_at_images, .. } = *bdpt;
        Self { limits, heuristic, techniques, splats_in_weights, aims_at_images }
    }

    /// The vertices of a light subpath after x₀; nothing if it left the scene at
    /// once.
    pub(crate) fn light_subpath(
        &self,
        tracer: &mut Tracer<'_>,
        sampler: &mut PathSampler,
        path: &mut Subpath,
    ) -> Option<LightStart> {
        // x₀, the direction from it, and x₁.
        let emitted = emit(tracer, sampler)?;
        let state = self.light_state(&emitted);
        let Emitted { light, x0, direction, x1, numbers, throughput, densities } = emitted;
        // x₀ itself is a vertex of every technique that begins there.
        let start = LightStart { light, x0, densities };
        path.vertices.push(state.extend_to(x1, -direction, throughput, numbers, self.heuristic));
        self.walk_on(Some(&start), tracer, sampler, path);
        Some(start)
    }

    /// Returns the state of x₀ that the first surface needs: the techniques that could have
    /// found it otherwise are light sampling and, if the lamp has an area, a hit.
    pub(crate) fn light_state(&self, emitted: &Emitted) -> SubpathState {
        let Emitted { x0, direction, densities, .. } = emitted;
        // Georgiev, equations 31 to 33, without vertex merging.
        let emission = f64::from(densities.emission);
        let sampled = self.techniques.samples_light(x0.is_point);
        let hit = self.techniques.hits && !x0.is_point;
        SubpathState {
            position: x0.site.position,
            is_sky: x0.is_sky,
            cosine: if x0.is_point { 0.0 } else { x0.cosine(*direction) },
            pdf: densities.direction,
            is_delta: false,
            d_vcm_factor: if sampled { f64::from(densities.toward) / emission } else { 0.0 },
            d_vc_factor: if hit { self.heuristic.raise(1.0 / emission) } else { 0.0 },
        }
    }

    /// The vertices of the camera subpath of a pixel, after the pinhole.
    pub(crate) fn camera_subpath(
        &self,
        tracer: &mut Tracer<'_>,
        pixel: u32,
        sampler: &mut PathSampler,
        path: &mut Subpath,
    ) {
        // A point of the film, drawn uniformly in the pixel.
        let camera = *tracer.scene.camera();
        let ray = camera.ray(pixel_corner(tracer.scene, pixel) + sampler.pixel_point());
        // x_{k−1}, the first surface.
        let numbers = sampler.vertex();
        let Some(SurfaceHit { point, transmittance }) =
            tracer.camera_ray(&ray, numbers.pass_through)
        else {
            return;
        };
        // Only splats could have found x₁ otherwise: equation 31 for the camera.
        let splats = if self.techniques.splats { self.splats_in_weights } else { 0.0 };
        let state = SubpathState {
            position: camera.position(),
            is_sky: false,
            cosine: 0.0,
            pdf: camera.pdf(ray.direction),
            is_delta: false,
            d_vcm_factor: splats,
            d_vc_factor: 0.0,
        };
        path.vertices.push(state.extend_to(
            point,
            -ray.direction,
            transmittance,
            numbers,
            self.heuristic,
        ));
        self.walk_on(None, tracer, sampler, path);
    }

    /// Extends a subpath whose first edge is walked, from a light or from the camera.
    fn walk_on(
        &self,
        from_light: Option<&LightStart>,
        tracer: &mut Tracer<'_>,
        sampler: &mut PathSampler,
        path: &mut Subpath,
    ) {
        let roulette = self.limits.roulette;
        let walk = if from_light.is_some() { Walk::FromLight } else { Walk::FromCamera };
        // One more edge must fit behind each vertex of a light path, to join it to the camera.
        let joining = u32::from(from_light.is_some());
        for edge in 2.. {
            let Some(last) = path.vertices.last() else { return };
            // There must be room for this edge and for those that join it.
            if !self.limits.allow(edge + joining) {
                return;
            }
            // A direction from the last vertex, and the vertex that it leads to.
            let Vertex { point, wo, numbers, .. } = last;
            let way = path.toward_light(last);
            let step = next_step_toward_light(walk, way, point, *wo, numbers, roulette, edge);
            let Some(step) = step else { return };
            let numbers = sampler.vertex();
            let hit = tracer.later_edge(walk, &step.ray, numbers.pass_through);
            let Some(hit) = hit else { return };
            let Some(last) = path.vertices.last_mut() else { return };
            // Its partial weights, for whoever connects further on.
            let pdf_back = self.pdf_back(walk, tracer.scene, last, &step.sample, &hit.point);
            let connections = self.techniques.connections;
            let state = last.scatter(&step.sample, pdf_back, connections, self.heuristic);
            let (wo, throughput) = (-step.sample.wi, last.throughput * step.weight);
            let throughput = throughput * hit.transmittance;
            let aims = self.aims_at_images && walk == Walk::FromCamera && last.is_sharp;
            let mut next = state.extend_to(hit.point, wo, throughput, numbers, self.heuristic);
            if let Some(start) = from_light {
                // The vertices of this path, which the list may hold others before.
                let own = path.vertices.len() + 1 - edge as usize;
                self.note_mirrors(tracer.scene, start, &path.vertices[own..], &mut next);
            }
            path.vertices.push(next);
            // What the camera sees by way of something sharp aims at images.
            if aims {
                path.aim(tracer.scene);
            }
        }
    }

    /// Where `between`, x₁ or x₁ and x₂, reflected a point light's path ideally to `next`: the
    /// edge to it cannot be connected, but it may be joined with the light by way of those mirrors,
    /// and M stands for that.
    pub(crate) fn note_mirrors(
        &self,
        scene: &Scene,
        start: &LightStart,
        between: &[Vertex],
        next: &mut Vertex,
    ) {
        let LightStart { light, x0, densities } = start;
        if !(self.techniques.mirror_connections && x0.is_point && next.after_delta) {
            return;
        }
        let to = next.point.site.position;
        let spread = match between {
            [x1] => scene.mirrored_walk_spread(*light, x0, &[&x1.point], to),
            [x1, x2] if x2.after_delta => {
                scene.mirrored_walk_spread(*light, x0, &[&x1.point, &x2.point], to)
            }
            _ => None,
        };
        if let Some(spread) = spread {
            next.d_vcm = 1.0 / walked_by_mirror(densities, spread, &next.point, next.wo);
        }
    }

    /// Density with which the walk from the other end would have gone back to the vertex before
    /// `last`, from which this one went on to `next`.
    #[inline]
    fn pdf_back(
        &self,
        walk: Walk,
        scene: &Scene,
        last: &Vertex,
        sample: &BsdfSample,
        next: &SurfacePoint,
    ) -> SolidAnglePdf {
        let own = sample.pdf_reverse;
        // Only now it is known whether a walk from the camera would have aimed at images.
        let aims = self.aims_at_images && walk == Walk::FromLight;
        if aims && !sample.is_delta && next.is_sharp() {
            let images = images_for(scene, &last.point);
            TowardLight::of(images.as_ref()).pdf(&last.point, own, last.wo)
        } else {
            own
        }
    }
}
