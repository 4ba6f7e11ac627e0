//! Point lights in ideal mirrors: images that no direction meets, and that can be joined
//! with a surface all the same.

use super::mirror::Mirror;
use crate::surfaces::{Surface, Surfaces};
use crate::{Light, LightId, LightPoint, Scene, SurfacePoint};
use traylib_geometry::{Hit, Ray, SurfaceSite};
use traylib_materials::Material;
use traylib_math::{DiscreteDistribution, Rgb, Vec2, Vec3};

/// Of so many pairs of mirror and light or fewer all are looked at from a point, of more only
/// one that is drawn.
const MOST_PAIRS: usize = 32;
/// No mirror and no light is drawn much more rarely than this part of its share if all were
/// alike.
const RAREST: f64 = 1.0 / 16.0;

/// Every ideal mirror whose images are where geometry has them, and every point light.
#[derive(Debug)]
pub(crate) struct MirroredPoints {
    mirrors: Vec<NumberedMirror>,
    mirror_by_area: DiscreteDistribution,
    lights: Vec<LightId>,
    light_by_power: DiscreteDistribution,
}

/// A mirror, and which of the scene's surfaces it is.
#[derive(Clone, Copy, Debug)]
struct NumberedMirror {
    mirror: Mirror,
    surface: u32,
}

/// A point light as a surface sees it in an ideal mirror.
///
/// Light from there arrives by one direction alone, so that there is no density to divide by:
/// the path from the light by way of the mirror is found for certain.
#[derive(Clone, Copy, Debug)]
pub struct PointImage {
    /// Unit direction from the surface to where it sees the image.
    pub wi: Vec3,
    /// That place on the mirror.
    pub seen_at: SurfaceSite,
    /// The light.
    pub x0: LightPoint,
    /// What arrives, unless something stands in the way, on a surface that faces the image, in
    /// W/m²; the mirror's reflectance and opacity are in it, and the chance to have looked for
    /// this image.
    pub irradiance: Rgb,
}

impl MirroredPoints {
    /// Those of a scene, if there are any.
    pub(super) fn new(
        surfaces: &Surfaces,
        materials: &[Material],
        lights: &[Light],
    ) -> Option<Self> {
        let is_point = |(_, light): &(u32, &Light)| light.is_point();
        let (lights, powers): (Vec<LightId>, Vec<f32>) = (0..)
            .zip(lights)
            .filter(is_point)
            .map(|(index, light)| (LightId(index), light.power().luminance()))
            .unzip();
        let light_by_power = DiscreteDistribution::with_floor(&powers, RAREST)?;
        let numbered = |(number, surface): (u32, Surface<'_>)| {
            let mirror = ideal_mirror(surface, materials)?;
            Some(NumberedMirror { mirror, surface: number })
        };
        let mirrors: Vec<NumberedMirror> = (0..).zip(surfaces.all()).filter_map(numbered).collect();
        let areas: Vec<f32> = mirrors.iter().map(|numbered| numbered.mirror.area).collect();
        let mirror_by_area = DiscreteDistribution::with_floor(&areas, RAREST)?;
        Some(Self { mirrors, mirror_by_area, lights, light_by_power })
    }

    /// How many pairs are looked at.
    fn looks(&self) -> usize {
        let pairs = self.mirrors.len() * self.lights.len();
        if pairs <= MOST_PAIRS { pairs } else { 1 }
    }

    /// A pair to look at, and the chance to do so; `u` is uniform.
    fn pair(&self, look: usize, u: [f64; 2]) -> (NumberedMirror, LightId, f32) {
        let count = self.lights.len();
        if self.mirrors.len() * count <= MOST_PAIRS {
            return (self.mirrors[look / count], self.lights[look % count], 1.0);
        }
        // By how much light there may be: many mirrors are parts of one as a rule.
        let (mirror, of_mirrors) = self.mirror_by_area.choose(u[0]);
        let (light, of_lights) = self.light_by_power.choose(u[1]);
        (self.mirrors[mirror], self.lights[light], of_mirrors * of_lights)
    }
}

/// A surface as an ideal mirror. Relief bends its images as smooth normals do.
fn ideal_mirror(surface: Surface<'_>, materials: &[Material]) -> Option<Mirror> {
    let has_relief =
        materials[surface.material()].maps.as_ref().is_some_and(|maps| maps.bump.is_some());
    super::mirror(surface, materials).filter(|mirror| mirror.is_ideal() && !has_relief)
}

impl Scene {
    /// Whether ideal mirrors show point lights.
    #[inline]
    pub fn has_point_images(&self) -> bool {
        self.stage.mirrored_lamps.points.is_some()
    }

    /// The images of point lights that a surface at this point sees in ideal mirrors: flat ones
    /// and balls from outside, by one reflection. Of very many one is looked for at random, by
    /// `u`, uniform on [0, 1), so that the mean over `u` is right.
    ///
    /// What stands between is left out: the segments from the surface to the mirror and from
    /// there to the light have to be asked for.
    pub fn point_images<'a>(
        &'a self,
        point: &'a SurfacePoint,
        u: [f64; 2],
    ) -> impl Iterator<Item = PointImage> + 'a {
        self.stage.mirrored_lamps.points.iter().flat_map(move |points| {
            (0..points.looks()).filter_map(move |look| {
                let (mirror, light, chance) = points.pair(look, u);
                self.point_image(point, mirror, light, chance)
            })
        })
    }

    #[inline(never)]
    fn point_image(
        &self,
        point: &SurfacePoint,
        NumberedMirror { mirror, surface }: NumberedMirror,
        id: LightId,
        chance: f32,
    ) -> Option<PointImage> {
        // Where the image is seen.
        let from = point.site.position;
        let (x0, _) = self.sample_light(id, from, Vec2::ZERO);
        let reflection = mirror.reflection(from, x0.site.position)?;
        let wi = reflection.toward.normalize_or_zero().as_vec3();
        if !point.may_scatter_to(wi) {
            return None;
        }
        // If the mirror reaches there, what it is like.
        let ray = Ray::new(point.site.ray_origin(wi), wi);
        let shape = self.surface_of(surface);
        let hit = shape.primitive()?.intersect(&ray, shape.sides())?;
        let hit = Hit { t: hit.t, u: hit.u, v: hit.v, primitive: surface };
        let seen = self.surface_point(&ray, hit)?;
        let reflectance = seen.model.mirror_reflectance()? * seen.opacity;
        // What the light sends there.
        let falloff = x0.falloff((seen.site.position - x0.site.position).try_normalize()?);
        let spread = (reflection.spread / f64::from(chance)) as f32;
        let irradiance = x0.emitted * reflectance * (falloff * spread);
        (!irradiance.is_black()).then_some(PointImage { wi, seen_at: seen.site, x0, irradiance })
    }
}

#[cfg(test)]
mod tests;
