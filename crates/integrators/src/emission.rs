//! How a light path starts.

use crate::tracer::Tracer;
use traylib_geometry::Ray;
use traylib_math::{Rgb, Sampler, Vec2, Vec3};
use traylib_scene::{LightDensities, LightPoint, SurfacePoint};

/// The first edge of a light path and the surface it met.
pub(crate) struct Emitted<'scene> {
    pub(crate) x0: LightPoint,
    pub(crate) direction: Vec3,
    pub(crate) x1: SurfacePoint<'scene>,
    /// Le·cos₀/(F₀·p), with the densities of start and direction; of a point light
    /// its intensity in place of Le·cos₀.
    pub(crate) throughput: Rgb,
    pub(crate) densities: LightDensities,
}

/// Emits a light path; `None` if it leaves the scene at once.
pub(crate) fn emit<'scene>(
    tracer: &mut Tracer<'scene>,
    sampler: &mut Sampler,
) -> Option<Emitted<'scene>> {
    let numbers = sampler.next_vertex();
    let choice = tracer.scene.choose_light(numbers.light_pick);
    let u_direction = Vec2::new(numbers.bsdf[1], numbers.bsdf[2]);
    let emission = choice.light.sample_emission(numbers.light_point, u_direction);
    let (x0, direction) = (emission.point, emission.direction);
    let x1 = tracer.emission_ray(&Ray::new(x0.ray_origin(direction), direction))?;
    let x1_position = x1.site.position;
    let densities = tracer.scene.light_densities(choice.id, &x0, x1_position, direction);
    let density = densities.emission * densities.direction.0;
    let falloff = x0.falloff(direction);
    (falloff > 0.0).then(|| Emitted {
        x0,
        direction,
        x1,
        throughput: x0.emitted * (falloff / density),
        densities,
    })
}
