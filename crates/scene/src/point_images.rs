//! Point lights as surfaces see them in ideal mirrors.

use crate::images::{NumberedMirror, Reflection};
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
    /// Which light that is.
    pub light: LightId,
    /// What arrives, unless something stands in the way, on a surface that faces the image, in
    /// W/m²; the mirror's reflectance and opacity are in it, and the chance to have looked for
    /// this image.
    pub irradiance: Rgb,
    /// What walks from the light make of the same way: see [`Scene::mirrored_walk_spread`].
    pub walk_spread: f64,
}

impl Scene {
    /// Tells whether ideal mirrors show point lights.
    #[inline]
    pub fn has_point_images(&self) -> bool {
        self.stage.mirrored_lights.points.is_some()
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
        self.stage.mirrored_lights.points.iter().flat_map(move |points| {
            (0..points.tries()).filter_map(move |number| {
                let (mirror, light, chance) = points.pair(number, u);
                self.point_image(point, mirror, light, chance)
            })
        })
    }

    /// A walk from the point light `x0` met `x1`, was reflected ideally there, and came to `x2`:
    /// the density of its first direction times this is that of its coming to `x2` that way, per
    /// area that faces the image, over the chance with which [`point_images`](Self::point_images)
    /// looks for that image; in sr/m². `None` where it does not look for it.
    ///
    /// So the weights of both know one another: the walk comes to x₂ with the density
    /// p(w)·c·dw/dA, c the mirror's chance to reflect.
    pub fn mirrored_walk_spread(
        &self,
        light: LightId,
        x0: &LightPoint,
        x1: &SurfacePoint,
        x2: Vec3,
    ) -> Option<f64> {
        let points = self.stage.mirrored_lights.points.as_ref()?;
        let (mirror, look_chance) = points.pair_of(x1.surface, light)?;
        let reflection = mirror.reflection(x2, x0.site.position)?;
        walk_spread(&reflection, x1, look_chance)
    }

    #[inline(never)]
    fn point_image(
        &self,
        point: &SurfacePoint,
        NumberedMirror { mirror, surface }: NumberedMirror,
        light: LightId,
        chance: f32,
    ) -> Option<PointImage> {
        // Where the image is seen.
        let from = point.site.position;
        let (x0, _) = self.sample_light(light, from, Vec2::ZERO);
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
        let walk_spread = walk_spread(&reflection, &seen, chance)?;
        let seen_at = seen.site;
        let image = PointImage { wi, seen_at, x0, light, irradiance, walk_spread };
        (!irradiance.is_black()).then_some(image)
    }
}

/// See [`Scene::mirrored_walk_spread`]; the mirror as it is where light meets it.
fn walk_spread(reflection: &Reflection, mirror: &SurfacePoint, look_chance: f32) -> Option<f64> {
    let reflected = f64::from(mirror.model.mirror_chance()?);
    Some(reflected * reflection.spread / f64::from(look_chance))
}

#[cfg(test)]
mod tests;
