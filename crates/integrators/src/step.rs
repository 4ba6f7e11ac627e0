//! The next step of a walk: the same for walks from either end.

use crate::limits::Roulette;
use crate::numbers::VertexNumbers;
use crate::toward_light::TowardLight;
use traylib_geometry::Ray;
use traylib_materials::BsdfSample;
use traylib_math::{Rgb, Vec3};
use traylib_scene::{SurfacePoint, Walk};

/// The next edge of a walk.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The ray toward the next vertex.
    pub ray: Ray,
    /// The factor of the throughput, roulette included.
    pub weight: Rgb,
    /// The direction as it was sampled, with its densities; its own weight is that of the surface.
    pub sample: BsdfSample,
}

/// The edge with number `edge` of a walk that arrived at `point` from `wo`;
/// `None` where the walk ends. `wo` is unit and leads back; `numbers` are those of this
/// vertex.
#[inline]
pub fn next_step(
    walk: Walk,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
    roulette: Roulette,
    edge: u32,
) -> Option<Step> {
    let by_surface = TowardLight::BY_SURFACE;
    next_step_toward_light(walk, by_surface, point, wo, numbers, roulette, edge)
}

/// The same for a walk that may look for light in its own way; one from a light goes on by
/// the surface alone.
#[expect(
    clippy::inline_always,
    reason = "its result is large: in place it is not written to memory"
)]
#[inline(always)]
pub fn next_step_toward_light(
    walk: Walk,
    toward_light: TowardLight<'_>,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
    roulette: Roulette,
    edge: u32,
) -> Option<Step> {
    // A direction, with the surface's own f·cos/p.
    let own = toward_light.sample(point, wo, numbers.bsdf)?;
    let own_weight = point.walk_weight(walk, wo, &own);
    // The chance to go on is paid for by the weight. It goes by the surface's own: by the
    // mixture's it would end just those walks that were sent toward an image.
    let chance = roulette.survive(edge, own_weight, numbers.roulette)?;
    // The same light by the density of the mixture.
    let (pdf, weight) = if own.is_delta || !toward_light.is_mixture() {
        (own.pdf, own_weight)
    } else {
        let pdf = toward_light.pdf(point, own.pdf, own.wi);
        (pdf, own_weight * (own.pdf.0 / pdf.0))
    };
    // Radiance is compressed by refraction, power is not; roulette is for power.
    let eta_scale = if walk == Walk::FromCamera { own.eta_scale } else { 1.0 };
    let ray = Ray::new(point.site.ray_origin(own.wi), own.wi);
    let sample = BsdfSample { pdf, ..own };
    Some(Step { ray, weight: weight * (eta_scale / chance), sample })
}
