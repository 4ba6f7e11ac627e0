//! Point lights as surfaces see them in ideal mirrors.

use crate::images::{MirrorPath, NumberedMirror};
use crate::{LightId, LightPoint, Scene, SurfacePoint};
use traylib_geometry::{Hit, Ray, SurfaceSite};
use traylib_math::{Rgb, Vec2, Vec3};

/// A point light as a surface sees it in an ideal mirror, or in one that a flat one shows.
///
/// Light from there arrives by one direction alone, so that there is no density to divide by:
/// the path from the light by way of the mirrors is found for certain.
#[derive(Clone, Copy, Debug)]
pub struct PointImage {
    /// Unit direction from the surface to where it sees the image.
    pub wi: Vec3,
    /// The place on the mirror.
    pub seen_at: SurfaceSite,
    /// The place on the mirror that is seen there, if not the light itself.
    pub shown_at: Option<SurfaceSite>,
    /// The light.
    pub x0: LightPoint,
    /// The light.
    pub light: LightId,
    /// The irradiance, unless something stands in the way, of a surface that faces the image, in
    /// W/m²; reflectance and opacity of mirrors are in it, and the chance to have looked for
    /// this image.
    pub irradiance: Rgb,
    /// The spread of walks from the light that take the same path: see
    /// [`Scene::mirrored_walk_spread`].
    pub walk_spread: f64,
}

impl PointImage {
    /// Returns the number of mirrors between the surface and the light.
    pub fn mirrors(&self) -> u32 {
        1 + u32::from(self.shown_at.is_some())
    }

    /// Returns the point at which the light falls on a mirror.
    pub fn lit_at(&self) -> &SurfaceSite {
        self.shown_at.as_ref().unwrap_or(&self.seen_at)
    }
}

impl Scene {
    /// Tells whether ideal mirrors show point lights.
    #[inline]
    pub fn has_point_images(&self) -> bool {
        self.stage.mirrored_lights.points.is_some()
    }

    /// The images of point lights that a surface at this point sees in ideal mirrors: flat ones
    /// and balls from outside, by one reflection, and what of these flat ones show, where there
    /// are few of them. Of very many one is looked for at random, by `u`, uniform on [0, 1), so
    /// that the mean over `u` is right.
    ///
    /// Occlusion is left out: the segments from the surface to the mirror and from there on to the
    /// light have to be asked for.
    pub fn point_images<'a>(
        &'a self,
        point: &'a SurfacePoint,
        u: [f64; 2],
    ) -> impl Iterator<Item = PointImage> + 'a {
        self.stage.mirrored_lights.points.iter().flat_map(move |points| {
            (0..points.tries()).filter_map(move |attempt| {
                let (path, light, chance) = points.image(attempt, u);
                self.point_image(point, &path, light, chance)
            })
        })
    }

    /// A walk from the point light `x0` met these mirrors, was reflected ideally by each, and came
    /// to a place: the density of its first direction times this is that of its coming there that
    /// path, per area that faces the image, over the chance with which
    /// [`point_images`](Self::point_images) looks for that image; in sr/m². `None` where it does
    /// not look for it.
    ///
    /// So the weights of both know one another: the walk comes there with the density
    /// p(w)·c·dw/dA, c the chance of the mirrors to reflect.
    pub fn mirrored_walk_spread(
        &self,
        light: LightId,
        x0: &LightPoint,
        mirrors: &[&SurfacePoint],
        to: Vec3,
    ) -> Option<f64> {
        let points = self.stage.mirrored_lights.points.as_ref()?;
        let (path, attempt_chance) = match *mirrors {
            [x1] => points.path_of(&[x1.surface], light),
            [x1, x2] => points.path_of(&[x1.surface, x2.surface], light),
            _ => None,
        }?;
        let reflection = path.reflection(to, x0.site.position)?;
        let chances = mirrors.iter().map(|mirror| mirror.model.mirror_chance().map(f64::from));
        let reflected = chances.product::<Option<f64>>()?;
        Some(reflected * reflection.spread / f64::from(attempt_chance))
    }

    #[inline(never)]
    fn point_image(
        &self,
        point: &SurfacePoint,
        path: &MirrorPath,
        light: LightId,
        chance: f32,
    ) -> Option<PointImage> {
        // Where the image is seen.
        let from = &point.site;
        let (x0, _) = self.sample_light(light, from.position, Vec2::ZERO);
        let light_at = x0.site.position;
        let reflection = path.reflection(from.position, light_at)?;
        let wi = reflection.toward.normalize_or_zero().as_vec3();
        if !point.may_scatter_to(wi) {
            return None;
        }
        // If the mirrors reach there, what they are like.
        let seen = self.met(&path.seen, from, wi)?;
        let mut mirrored = MirroredLight::by(&seen)?;
        let mut shown_at = None;
        if let Some(shown) = &path.shown {
            let on = shown.mirror.reflection(seen.site.position, light_at)?;
            let toward = on.toward.normalize_or_zero().as_vec3();
            // Light is reflected to the side from which it comes.
            if seen.normal.dot(toward) <= 0.0 {
                return None;
            }
            let shown = self.met(shown, &seen.site, toward)?;
            mirrored = mirrored.and(&MirroredLight::by(&shown)?);
            shown_at = Some(shown.site);
        }
        // What the light sends there.
        let spread = reflection.spread / f64::from(chance);
        let walk_spread = f64::from(mirrored.chance) * spread;
        let mut image = PointImage {
            wi,
            seen_at: seen.site,
            shown_at,
            x0,
            light,
            irradiance: Rgb::BLACK,
            walk_spread,
        };
        let falloff = x0.falloff((image.lit_at().position - light_at).try_normalize()?);
        image.irradiance = x0.emitted * mirrored.reflectance * (falloff * spread as f32);
        (!image.irradiance.is_black()).then_some(image)
    }

    /// A mirror where it is met in this direction, if it reaches there.
    fn met(
        &self,
        &NumberedMirror { surface, .. }: &NumberedMirror,
        from: &SurfaceSite,
        direction: Vec3,
    ) -> Option<SurfacePoint> {
        let ray = Ray::new(from.ray_origin(direction), direction);
        let shape = self.surface_of(surface);
        let hit = shape.primitive()?.intersect(&ray, shape.sides())?;
        let hit = Hit { t: hit.t, u: hit.u, v: hit.v, primitive: surface };
        self.surface_point(&ray, hit)
    }
}

/// The part of light that mirrors leave, and the chance of walks, where they reflect ideally.
struct MirroredLight {
    reflectance: Rgb,
    /// The chance with which a walk is reflected so.
    chance: f32,
}

impl MirroredLight {
    fn by(mirror: &SurfacePoint) -> Option<Self> {
        let SurfacePoint { model, opacity, .. } = mirror;
        Some(Self {
            reflectance: model.mirror_reflectance()? * *opacity,
            chance: model.mirror_chance()?,
        })
    }

    /// Returns what both make of light, one after the other.
    fn and(&self, other: &Self) -> Self {
        Self {
            reflectance: self.reflectance * other.reflectance,
            chance: self.chance * other.chance,
        }
    }
}

#[cfg(test)]
mod tests;
