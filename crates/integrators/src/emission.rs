//! The start of a light path.

use crate::numbers::{PathSampler, VertexNumbers};
use crate::tracer::{SurfaceHit, Tracer};
use traylib_geometry::Ray;
use traylib_math::{Rgb, Vec2, Vec3};
use traylib_scene::{LightDensities, LightId, LightPoint, SurfacePoint};

/// The first edge of a light path and the surface it met.
#[derive(Clone, Copy, Debug)]
pub struct Emitted {
    /// The lamp.
    pub light: LightId,
    /// The point of the lamp where it starts.
    pub x0: LightPoint,
    /// The unit direction that it takes.
    pub direction: Vec3,
    /// The first surface.
    pub x1: SurfacePoint,
    /// The random numbers of x₁.
    pub numbers: VertexNumbers,
    /// Le·cos₀/(F₀·p), with the densities of start and direction, and what the
    /// edge passed; of a point light its intensity in place of Le·cos₀.
    pub throughput: Rgb,
    /// The densities of its start, as a weight needs them.
    pub densities: LightDensities,
}

/// Emits a light path; `None` if it leaves the scene at once.
pub fn emit(tracer: &mut Tracer<'_>, sampler: &mut PathSampler) -> Option<Emitted> {
    tracer.statistics.light_paths += 1;
    // A lamp by its power, a point on it, and a direction.
    let start = sampler.vertex();
    let choice = tracer.scene.choose_light(start.light_pick);
    let u_direction = Vec2::new(start.bsdf[1], start.bsdf[2]);
    let emission = tracer.scene.sample_emission(choice.id, start.light_point, u_direction);
    let numbers = sampler.vertex();
    let (x0, direction) = (emission.point, emission.direction);
    let falloff = x0.falloff(direction);
    if falloff <= 0.0 || x0.emitted.is_black() {
        return None;
    }
    // The first surface.
    let ray = Ray::new(x0.ray_origin(direction), direction);
    let SurfaceHit { point: x1, transmittance } = tracer.bounce_ray(&ray, numbers.pass_through)?;
    // Le·cos₀ over the density of all that.
    let x1_position = x1.site.position;
    let densities = tracer.scene.light_densities(choice.id, &x0, x1_position, direction);
    let density = densities.emission * densities.direction.0;
    Some(Emitted {
        light: choice.id,
        x0,
        direction,
        x1,
        numbers,
        throughput: x0.emitted * transmittance * (falloff / density),
        densities,
    })
}
