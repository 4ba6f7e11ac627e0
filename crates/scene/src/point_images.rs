//! Point lights as surfaces see them in ideal mirrors.

use crate::images::NumberedMirror;
use crate::{LightId, LightPoint, Scene, SurfacePoint};
use traylib_geometry::{Hit, Ray, SurfaceSite};
use traylib_math::{Rgb, Vec2, Vec3};

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
