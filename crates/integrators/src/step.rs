//! How a walk goes on: the same for walks from either end.

use crate::limits::Roulette;
use crate::numbers::VertexNumbers;
use traylib_geometry::Ray;
use traylib_materials::BsdfSample;
use traylib_math::{Rgb, Vec3};
use traylib_scene::{SurfacePoint, Walk};

/// The next edge of a walk.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where to look for the next vertex.
    pub ray: Ray,
    /// What the throughput is multiplied with, roulette included.
    pub weight: Rgb,
    /// The direction as the surface sampled it, with its densities.
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
    // A direction of the surface's own, with f·cos/p.
    let sample = point.sample(wo, numbers.bsdf)?;
    let weight = point.walk_weight(walk, wo, &sample);
    // The chance to go on is paid for by the weight.
    let chance = roulette.survive(edge, weight, numbers.roulette)?;
    // Radiance is compressed by refraction, power is not; roulette is for power.
    let eta_scale = if walk == Walk::FromCamera { sample.eta_scale } else { 1.0 };
    let ray = Ray::new(point.site.ray_origin(sample.wi), sample.wi);
    Some(Step { ray, weight: weight * (eta_scale / chance), sample })
}
