//! Point lights by way of mirrors: a connection with one ideal reflection or two in its middle.

use crate::Limits;
use crate::numbers::VertexNumbers;
use crate::path_scattering::PathScattering;
use crate::tracer::Tracer;
use traylib_math::{Rgb, Vec3};
use traylib_scene::{LightDensities, PointImage, Scene, SurfacePoint, Walk};

/// A point light that a vertex is joined with by way of mirrors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MirroredLight {
    pub(crate) image: PointImage,
    /// The BSDF and densities at the vertex for the direction to the image.
    pub(crate) scattering: PathScattering,
    /// The radiance that it reflects of that light, unless something stands between.
    pub(crate) radiance: Rgb,
}

/// The point lights in mirrors whose light a vertex seen from the unit direction `wo`, after so
/// many edges, may reflect, as far as [`Scene::point_images`] knows them and paths may get so long.
#[inline]
pub(crate) fn mirrored_lights<'a>(
    scene: &'a Scene,
    point: &'a SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
    (edges, limits): (u32, Limits),
) -> impl Iterator<Item = MirroredLight> + 'a {
    // Numbers that area lamps alone use otherwise, and the one that chose a lamp.
    let u = [numbers.light_pick, f64::from(numbers.light_point.x)];
    let joins =
        scene.has_point_images() && limits.allow(edges + 2) && point.model.has_smooth_part();
    let images = joins.then(|| scene.point_images(point, u));
    images
        .into_iter()
        .flatten()
        .filter(move |image| limits.allow(edges + image.mirrors() + 1))
        .filter_map(move |image| MirroredLight::of(image, point, wo))
}

impl MirroredLight {
    /// Estimates the light of an image that the surface makes anything of.
    #[inline(never)]
    fn of(image: PointImage, point: &SurfacePoint, wo: Vec3) -> Option<Self> {
        let scattering = PathScattering::by_surface(point, Walk::FromCamera, wo, image.wi);
        let cosine = point.cosine(Walk::FromCamera, wo, image.wi);
        let radiance = scattering.f * image.irradiance * cosine;
        (!radiance.is_black()).then_some(Self { image, scattering, radiance })
    }

    /// Returns the transmittance of all edges, asked from the side of the eye; `None` if one is
    /// blocked.
    pub(crate) fn visible(&self, tracer: &mut Tracer<'_>, point: &SurfacePoint) -> Option<Rgb> {
        let PointImage { seen_at, shown_at, x0, .. } = &self.image;
        let mut transmittance = tracer.sees(&point.site.segment_to(seen_at))?;
        if let Some(shown_at) = shown_at {
            transmittance *= tracer.sees(&seen_at.segment_to(shown_at))?;
        }
        Some(transmittance * tracer.sees(&x0.segment_from(self.image.lit_at()))?)
    }
}

/// The density with which a walk from a point light comes by way of mirrors to `at`, in 1/m²,
/// over the chance that this place is joined with the light by way of them; `wi` is the unit
/// direction from there to the last mirror, `spread` that of [`Scene::mirrored_walk_spread`].
pub(crate) fn walked_by_mirror(
    densities: &LightDensities,
    spread: f64,
    at: &SurfacePoint,
    wi: Vec3,
) -> f64 {
    let start = f64::from(densities.emission) * f64::from(densities.direction.0);
    start * spread * f64::from(at.normal.dot(wi).abs())
}

/// The radiance that a vertex seen from the unit direction `wo`, after so many edges from the
/// camera, reflects of what point lights send it by way of ideal mirrors, as far as
/// [`Scene::point_images`] knows it and limits allow paths of that length.
///
/// A light walk may find the same paths, a walk from the camera never: a point light cannot be
/// hit after a mirror, nor aimed at from it.
#[inline]
pub fn light_through_mirrors(
    tracer: &mut Tracer<'_>,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
    (edges, limits): (u32, Limits),
) -> Rgb {
    let mut radiance = Rgb::BLACK;
    for light in mirrored_lights(tracer.scene, point, wo, numbers, (edges, limits)) {
        if let Some(transmittance) = light.visible(tracer, point) {
            radiance += light.radiance * transmittance;
        }
    }
    radiance
}
