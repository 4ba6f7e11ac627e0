//! The finished scene and the questions a renderer asks of it.

mod detail;
mod sample;

pub use detail::Detail;

use crate::coincidence::Coincidences;
use crate::images::{ImageDirections, MirroredLights};
use crate::light_choice::LightForPoint;
use crate::seat::{self, Seat};
use crate::surfaces::{Surface, Surfaces};
use crate::{Camera, Light, LightId, LightPoint, Sky, SurfacePoint};
use std::fmt::Write;
use std::sync::Arc;
use traylib_geometry::{Bvh, Hit, Ray, ShapeList, Shapes, SurfaceSite};
use traylib_materials::{Material, Shading};
use traylib_math::{DiscreteDistribution, Fnv, Rgb, SolidAnglePdf, Vec2, Vec3};

/// Camera, lamps and surfaces, ready to be rendered. Immutable.
///
/// All but the camera is shared: a scene seen by [another](Self::seen_by) costs nothing.
#[derive(Clone, Debug)]
pub struct Scene {
    camera: Camera,
    surfaces_at_camera: usize,
    pub(crate) stage: Arc<Stage>,
}

/// The stage: everything in the scene but the camera.
#[derive(Debug)]
pub(crate) struct Stage {
    pub(crate) tree: Bvh<Shapes<Surfaces>>,
    pub(crate) materials: Vec<Material>,
    /// Whether light passes straight through any of them.
    pub(crate) see_through: bool,
    pub(crate) lights: Vec<Light>,
    /// Whether any of them is a point.
    pub(crate) has_points: bool,
    /// The seats: what each lamp lies on; none where that matters for no lamp.
    pub(crate) seats: Vec<Seat>,
    pub(crate) lifted_lights: usize,
    pub(crate) light_by_power: DiscreteDistribution,
    pub(crate) light_for_point: LightForPoint,
    pub(crate) mirrored_lights: MirroredLights,
}

/// A lamp that was drawn.
#[derive(Clone, Copy, Debug)]
pub struct LightChoice<'scene> {
    /// Its name.
    pub id: LightId,
    /// The lamp.
    pub light: &'scene Light,
    /// The chance to draw it.
    pub probability: f32,
}

/// The densities of one point on a lamp as the first vertex x₀ of a path, each
/// with the chance to choose the lamp: by power to emit, by power and nearness for
/// light sampling.
///
/// Area densities are per m²; those of a point light are plain probabilities. For the sky those
/// of x₀ are per steradian and that of the direction per m²: see [`Sky`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDensities {
    /// F₀: a light path starts here.
    pub emission: f32,
    /// A light path from here takes the direction to x₁, per steradian.
    pub direction: SolidAnglePdf,
    /// pN₀: light sampling for x₁ chooses this point.
    pub toward: f32,
}

/// More surfaces than this in a row let nothing through. Rounding could otherwise
/// hold a ray for ever where panes meet.
pub const MAX_PASS_THROUGHS: u32 = 1000;

/// The distance, as a part of the way, at which two surfaces are met that share an edge.
const EDGE: f32 = 1.0 / (1 << 18) as f32;

impl Scene {
    pub(crate) fn new(stage: Arc<Stage>, camera: Camera) -> Self {
        let camera_in: Vec<SurfaceSite> =
            seat::touching(camera.position(), stage.tree.shapes()).collect();
        Self {
            camera: camera_in.iter().fold(camera, Camera::lifted),
            surfaces_at_camera: camera_in.len(),
            stage,
        }
    }

    /// Returns the scene with another camera, as a window needs it that is walked through:
    /// nothing is built again.
    #[must_use]
    pub fn seen_by(&self, camera: Camera) -> Self {
        Self::new(Arc::clone(&self.stage), camera)
    }

    /// A hash of all that is in the scene, its camera included: another scene has another, but
    /// by a chance of 5·10⁻²⁰. It stays the same from one processor to the next, not from
    /// one version of this package to the next.
    pub fn content_hash(&self) -> u64 {
        let mut hash = Fnv::default();
        // What is derived from all of it; hashing takes everything.
        let _ = write!(hash, "{self:?}");
        hash.finish()
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// All lamps; every emitting primitive is one.
    pub fn lights(&self) -> &[Light] {
        &self.stage.lights
    }

    /// Whether any lamp is a point.
    #[inline]
    pub fn has_point_lights(&self) -> bool {
        self.stage.has_points
    }

    /// All materials.
    pub fn materials(&self) -> &[Material] {
        &self.stage.materials
    }

    /// Returns the counts of what lay in one place and was told apart.
    pub fn coincidences(&self) -> Coincidences {
        let is_within = |seat: &&Seat| matches!(seat, Seat::Within(_));
        Coincidences {
            lifted_lights: self.stage.lifted_lights,
            points_in_surfaces: self.stage.seats.iter().filter(is_within).count(),
            surfaces_at_camera: self.surfaces_at_camera,
        }
    }

    /// Returns the number of primitives, each triangle of a mesh counted as one.
    pub fn primitive_count(&self) -> usize {
        self.stage.tree.shapes().count()
    }

    /// The first surface that a ray or a segment meets, be it one that light passes
    /// straight through or not.
    #[expect(
        clippy::inline_always,
        reason = "its result is large: in place it is not written to memory"
    )]
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray) -> Option<SurfacePoint> {
        let hit = self.stage.tree.nearest(ray)?;
        self.surface_point(ray, hit)
    }

    /// [`intersect`](Self::intersect) for each ray of a list, in less time than one by one:
    /// those of a camera, row by row, go through the tree in packets of eight.
    pub fn intersect_each<'a>(
        &'a self,
        rays: &'a [Ray],
    ) -> impl Iterator<Item = Option<SurfacePoint>> + 'a {
        let mut hits = vec![None; rays.len()];
        self.stage.tree.nearest_each(rays, &mut hits);
        rays.iter().zip(hits).map(|(ray, hit)| self.surface_point(ray, hit?))
    }

    /// The surface where a ray has hit it.
    #[expect(
        clippy::inline_always,
        reason = "its result is large: in place it is not written to memory"
    )]
    #[inline(always)]
    pub(crate) fn surface_point(&self, ray: &Ray, mut hit: Hit) -> Option<SurfacePoint> {
        let mut surface = self.surface(&hit);
        let mut site = surface.site(ray, &hit)?;
        let from_behind = site.normal.dot(ray.direction) > 0.0;
        if from_behind
            && surface.is_on_edge(&hit)
            && let Some((other, there)) = self.front_at_edge(ray, &hit)
        {
            (hit, surface, site) = (other, self.surface(&other), there);
        }
        let smooth = surface.smooth_normal(&hit).unwrap_or(site.normal);
        let at = Vec2::new(hit.u, hit.v);
        let material = &self.stage.materials[surface.material()];
        let shading = material.at(smooth, || surface.site_of_textures(at));
        let Shading { model, opacity, through, normal: front_shading } = shading;
        let is_front = site.normal.dot(ray.direction) <= 0.0;
        let side = if is_front { 1.0 } else { -1.0 };
        Some(SurfacePoint {
            site,
            normal: site.normal * side,
            shading_normal: front_shading * side,
            model: if is_front { model } else { model.seen_from_behind() },
            opacity,
            through,
            light: surface.light(),
            surface: hit.primitive,
        })
    }

    /// The front that a ray meets at the same edge as a hit from behind, if there is one:
    /// where the two belong to a solid, rounding must not show its inside at its outline.
    #[cold]
    fn front_at_edge(&self, ray: &Ray, hit: &Hit) -> Option<(Hit, SurfaceSite)> {
        let here = Ray { t_max: ray.t_max.min(hit.t * (1.0 + EDGE)), ..*ray };
        let sites = self.stage.tree.all_hits(&here).into_iter().filter_map(|other| {
            let site = self.surface(&other).site(ray, &other)?;
            Some((other, site))
        });
        sites.into_iter().find(|(_, site)| site.normal.dot(ray.direction) < 0.0)
    }

    /// Returns the surface that a ray has met.
    #[inline]
    fn surface(&self, hit: &Hit) -> Surface<'_> {
        self.surface_of(hit.primitive)
    }

    /// The surface of this number.
    #[inline]
    pub(crate) fn surface_of(&self, number: u32) -> Surface<'_> {
        self.stage.tree.shapes().get(number)
    }

    /// The part of the light that a segment lets through: white where nothing
    /// stands in its way. The segment is one made by
    /// [`SurfaceSite::segment_to`](traylib_geometry::SurfaceSite::segment_to)
    /// or its like: it has no slack of its own.
    pub fn transmittance(&self, segment: &Ray) -> Rgb {
        if self.stage.see_through {
            self.transmittance_of_panes(segment)
        } else if self.stage.tree.any_hit(segment) {
            Rgb::BLACK
        } else {
            Rgb::WHITE
        }
    }

    /// [`transmittance`](Self::transmittance) of each segment of a list, in less time than
    /// one by one.
    pub fn transmittance_each(&self, segments: &[Ray]) -> Vec<Rgb> {
        if self.stage.see_through {
            return segments.iter().map(|segment| self.transmittance_of_panes(segment)).collect();
        }
        let mut blocked = vec![false; segments.len()];
        self.stage.tree.any_hit_each(segments, &mut blocked);
        blocked.into_iter().map(|blocked| if blocked { Rgb::BLACK } else { Rgb::WHITE }).collect()
    }

    fn transmittance_of_panes(&self, segment: &Ray) -> Rgb {
        // Toward the sky there is none.
        let end = segment.t_max.is_finite().then(|| segment.at(segment.t_max));
        let (mut transmittance, mut rest) = (Rgb::WHITE, *segment);
        for _ in 0..MAX_PASS_THROUGHS {
            let Some(hit) = self.stage.tree.nearest(&rest) else { return transmittance };
            let surface = self.surface(&hit);
            let material = &self.stage.materials[surface.material()];
            // Most shadows are thrown by what lets nothing through anywhere.
            if !material.is_see_through() {
                return Rgb::BLACK;
            }
            let at = Vec2::new(hit.u, hit.v);
            transmittance *= material.through_at(|| surface.site_of_textures(at));
            if transmittance.is_black() {
                return transmittance;
            }
            let Some(site) = surface.site(&rest, &hit) else { return transmittance };
            let origin = site.ray_origin(rest.direction);
            rest = end.map_or(Ray::new(origin, rest.direction), |end| Ray::segment(origin, end));
        }
        Rgb::BLACK
    }

    /// A lamp to start a light path, drawn in proportion to its power, but none more
    /// than some 16 times as rarely as if all had the same.
    pub fn choose_light(&self, u: f64) -> LightChoice<'_> {
        let (index, probability) = self.stage.light_by_power.choose(u);
        LightChoice { id: LightId(index as u32), light: &self.stage.lights[index], probability }
    }

    /// A lamp to light a surface at `x1`: rather one that is strong, near and
    /// shines there, whatever stands between; the sky in a part of all cases that is its part
    /// of the power, from a quarter to three. A lamp that could light `x1` has a
    /// chance, and none is so weak that stronger ones leave it less than 2⁻⁸ at each
    /// turn of the tree.
    #[inline]
    pub fn choose_light_for(&self, x1: Vec3, u: f64) -> LightChoice<'_> {
        let (index, probability) = self.stage.light_for_point.choose(x1, u);
        LightChoice { id: LightId(index), light: &self.stage.lights[index as usize], probability }
    }

    /// The names of all lamps.
    pub fn light_ids(&self) -> impl Iterator<Item = LightId> + use<> {
        (0..self.stage.lights.len() as u32).map(LightId)
    }

    /// The lamp of this name.
    pub fn light(&self, id: LightId) -> &Light {
        &self.stage.lights[id.0 as usize]
    }

    /// Returns the directions in which a rough surface at this point sees images of lamps in
    /// mirrors, if it may see any.
    #[inline]
    pub fn image_directions(&self, point: &SurfacePoint) -> Option<ImageDirections> {
        self.stage.mirrored_lights.seen_from(point)
    }

    /// Tells whether lamps are a small part of all surfaces, so that a walk that waits to hit one,
    /// or its image in a mirror, waits long.
    #[inline]
    pub fn lights_are_small(&self) -> bool {
        self.stage.mirrored_lights.lights_are_small
    }

    /// The point as one of a lamp, if it emits toward the side it is seen from.
    pub fn emitting_point(&self, point: &SurfacePoint) -> Option<(LightId, LightPoint)> {
        let id = point.light?;
        match self.light(id) {
            Light::Area { radiance, .. } if point.is_front() => {
                Some((id, LightPoint::on_surface(point.site, *radiance)))
            }
            Light::Area { .. } | Light::Point(_) => None,
            Light::Sky(sky) => Some((id, sky.point(-point.site.normal))),
        }
    }

    /// The sky, if there is one.
    #[inline]
    pub fn sky(&self) -> Option<&Sky> {
        match self.stage.lights.last() {
            Some(Light::Sky(sky)) => Some(sky),
            Some(Light::Area { .. } | Light::Point(_)) | None => None,
        }
    }

    /// The sky that a ray of unit direction sees which meets no surface, as a surface that emits
    /// and reflects nothing: a [point of the sky](SurfacePoint::is_sky). `None` where there is no
    /// sky.
    pub fn sky_behind(&self, ray: &Ray) -> Option<SurfacePoint> {
        self.sky()?;
        let sky = LightId(self.stage.lights.len() as u32 - 1);
        Some(SurfacePoint::of_sky(ray.direction, sky))
    }

    /// Radiance that a surface emits toward the side it is seen from.
    pub fn emitted(&self, point: &SurfacePoint) -> Rgb {
        self.emitting_point(point).map_or(Rgb::BLACK, |(_, point)| point.emitted)
    }

    /// The densities of a lamp's point x₀ for a path that goes on to `x1` in the
    /// unit `direction`.
    pub fn light_densities(
        &self,
        id: LightId,
        x0: &LightPoint,
        x1: Vec3,
        direction: Vec3,
    ) -> LightDensities {
        let toward = self.toward_density(id, x0, x1);
        self.sampled_light_densities(id, toward, x0, direction)
    }

    /// The density per m², or of a point light the chance, with which light sampling for `x1`
    /// chooses this point of a lamp: [`LightDensities::toward`] alone.
    pub fn toward_density(&self, id: LightId, x0: &LightPoint, x1: Vec3) -> f32 {
        let chosen_for_x1 = self.stage.light_for_point.probability(id.0, x1);
        chosen_for_x1 * self.light(id).toward_pdf(x1, x0).0
    }

    /// Returns these densities for a point that light sampling has drawn, with this density: the
    /// chance with which [`choose_light_for`](Self::choose_light_for) chose the lamp times the
    /// density that came from [`sample_light`](Self::sample_light).
    pub fn sampled_light_densities(
        &self,
        id: LightId,
        toward: f32,
        x0: &LightPoint,
        direction: Vec3,
    ) -> LightDensities {
        let light = self.light(id);
        let chosen = self.stage.light_by_power.probability(id.0 as usize);
        let emission = chosen * light.emission_pdf(x0).0;
        LightDensities { emission, direction: light.direction_pdf(x0, direction), toward }
    }
}

#[cfg(test)]
mod tests;
