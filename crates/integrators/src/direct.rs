//! Light sampling: one point on one lamp for a vertex of a camera path.

use crate::numbers::VertexNumbers;
use crate::path_scattering::PathScattering;
use crate::toward_light::TowardLight;
use crate::tracer::Tracer;
use traylib_math::{Rgb, Vec2, Vec3, solid_angle_per_area};
use traylib_scene::{LightChoice, LightDensities, LightId, LightPoint, Scene, SurfacePoint, Walk};

/// A way from a lamp to a vertex that carries light, if nothing stands in it.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// The lamp that was chosen.
    pub id: LightId,
    /// The density with which this point of this lamp was drawn for the vertex.
    pub toward: f32,
    /// The point on it.
    pub x0: LightPoint,
    /// Unit direction from the vertex to the lamp.
    pub wi: Vec3,
    /// The squared distance of the two points, in m²; one of the sky.
    pub distance_squared: f32,
    /// The scattering of the vertex in this direction.
    pub scattering: PathScattering,
    /// Radiance toward `wo` that this sample estimates.
    pub radiance: Rgb,
}

/// Draws a lamp and a point on it for a vertex seen from the unit direction `wo`, with the
/// vertex's own numbers. `None` where no light can come that way.
#[expect(
    clippy::inline_always,
    reason = "its result is large: in place it is not written to memory"
)]
#[inline(always)]
pub fn sample_light(
    scene: &Scene,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
) -> Option<LightSample> {
    if !point.model.has_smooth_part() {
        return None;
    }
    // A lamp by what it may give this vertex.
    let choice = scene.choose_light_for(point.site.position, numbers.light_pick);
    sample_chosen_light(scene, point, wo, choice, numbers.light_point)
}

/// The same where only point lights count: `None` if another lamp is drawn.
pub(crate) fn sample_point_light(
    scene: &Scene,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
) -> Option<LightSample> {
    if !point.model.has_smooth_part() {
        return None;
    }
    let choice = scene.choose_light_for(point.site.position, numbers.light_pick);
    // What is not wanted is not sampled.
    if choice.light.is_point() {
        sample_chosen_light(scene, point, wo, choice, numbers.light_point)
    } else {
        None
    }
}

/// Draws a point on a lamp that was drawn for a vertex.
#[expect(
    clippy::inline_always,
    reason = "its result is large: in place it is not written to memory"
)]
#[inline(always)]
fn sample_chosen_light(
    scene: &Scene,
    point: &SurfacePoint,
    wo: Vec3,
    choice: LightChoice<'_>,
    light_point: Vec2,
) -> Option<LightSample> {
    // Rounding decides from which side a point of a convex lamp sees the rest of it.
    let is_own = point.light == Some(choice.id);
    if is_own && !choice.light.lights_itself() {
        return None;
    }
    // A point on it.
    let (x0, pdf) = scene.sample_light(choice.id, point.site.position, light_point);
    // At the rim of a sphere rounding can turn the point away from here.
    if pdf.0 <= 0.0 {
        return None;
    }
    // f·cos_s·Le·cos₀/d² over chance and density.
    let mut sample = aim(point, wo, choice.id, x0)?;
    sample.toward = choice.probability * pdf.0;
    sample.radiance *= 1.0 / sample.toward;
    Some(sample)
}

/// Samples every point light once, as seen from a vertex.
pub fn sample_point_lights<'a>(
    scene: &'a Scene,
    point: &'a SurfacePoint,
    wo: Vec3,
) -> impl Iterator<Item = LightSample> + 'a {
    scene.light_ids().filter(|&id| scene.light(id).is_point()).filter_map(move |id| {
        let (x0, _) = scene.sample_light(id, point.site.position, Vec2::ZERO);
        aim(point, wo, id, x0)
    })
}

/// The light that a given point of a lamp sends by way of the vertex, per area
/// of the lamp: f·cos_s·Le·cos₀/d².
#[expect(
    clippy::inline_always,
    reason = "its result is large: in place it is not written to memory"
)]
#[inline(always)]
fn aim(point: &SurfacePoint, wo: Vec3, id: LightId, x0: LightPoint) -> Option<LightSample> {
    // The geometry term, as far as the lamp's side of it.
    let (wi, distance_squared) = x0.seen_from(point.site.position)?;
    let falloff = x0.falloff(-wi);
    if falloff <= 0.0 {
        return None;
    }
    // What the surface makes of it.
    let scattering = PathScattering::by_surface(point, Walk::FromCamera, wo, wi);
    let cosine = point.cosine(Walk::FromCamera, wo, wi);
    let radiance =
        scattering.f * x0.emitted * (cosine * solid_angle_per_area(falloff, distance_squared));
    (!radiance.is_black()).then_some(LightSample {
        id,
        toward: 1.0,
        x0,
        wi,
        distance_squared,
        scattering,
        radiance,
    })
}

impl LightSample {
    /// Takes account of how the vertex's own walk goes on, with which the sample has to share.
    pub fn mix(&mut self, toward_light: TowardLight<'_>, point: &SurfacePoint) {
        self.scattering.mix(toward_light, point, self.wi);
    }

    /// The part of the light that arrives at the vertex, if any.
    pub fn visible(&self, tracer: &mut Tracer<'_>, point: &SurfacePoint) -> Option<Rgb> {
        tracer.sees(&self.x0.segment_from(&point.site))
    }

    /// Density with which the vertex's own walk would have found the lamp's point, per m², of the
    /// sky per steradian; zero for a point light.
    pub fn hit_pdf(&self) -> f32 {
        if self.x0.is_point {
            return 0.0;
        }
        let conversion = solid_angle_per_area(self.x0.cosine(-self.wi), self.distance_squared);
        self.scattering.toward_light.to_area(conversion).0
    }

    /// The densities of the lamp's point for the vertex, which it was drawn for.
    pub fn densities(&self, scene: &Scene) -> LightDensities {
        scene.sampled_light_densities(self.id, self.toward, &self.x0, -self.wi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bdpt::room;
    use traylib_geometry::Ray;
    use traylib_math::{Sampler, warp};

    /// The rim of a spherical lamp, where its density rounds to zero.
    #[test]
    fn the_rim_of_a_lamp_gives_no_infinite_light() {
        let scene = room();
        let mut sampler = Sampler::numbered(0, 0);
        let mut found = 0;
        for i in 0..400_000 {
            let direction = warp::uniform_sphere(sampler.next_2d());
            let ray = Ray::new(Vec3::new(0.0, 0.1, 0.9), direction);
            let Some(point) = scene.intersect(&ray) else { continue };
            let mut numbers = VertexNumbers::next(&mut sampler);
            numbers.light_point.x = 1.0 - (i % 4 + 1) as f32 * f32::EPSILON / 2.0;
            if let Some(light) = sample_light(&scene, &point, -direction, &numbers) {
                assert!(light.radiance.is_finite(), "{:?}", light.x0);
                found += 1;
            }
        }
        assert!(found > 10_000, "{found}");
    }
}
