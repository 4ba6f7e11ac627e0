//! The choice of directions at a rough vertex of a walk from the camera: by the surface's own
//! sampling, and where that pays toward the images of lamps in mirrors.

use traylib_materials::BsdfSample;
use traylib_math::{SolidAnglePdf, Vec3};
use traylib_scene::{ImageDirections, Scene, SurfacePoint, Walk};

/// The part of what is not reflected ideally that is drawn toward images, where all that mirrors
/// show can be aimed at.
const SHARE: f32 = 0.25;

/// A mixture of the surface's sampling with image directions: of density
/// (1 − a)·p + a·S·q, where p is the surface's own, q that of the images, S the chance that
/// the surface reflects by no mirror, and a the images' share.
///
/// A walk from a light goes on by the surface alone: it needs the mixture where it weighs
/// what the camera's walk would have done.
#[derive(Clone, Copy, Debug)]
pub struct TowardLight<'a> {
    images: Option<&'a ImageDirections>,
}

/// The images that a walk from the camera may aim at from a point: none if its surface
/// scatters into no wide directions.
#[inline]
pub fn images_for(scene: &Scene, point: &SurfacePoint) -> Option<ImageDirections> {
    if can_aim(point) { scene.image_directions(point) } else { None }
}

impl<'a> TowardLight<'a> {
    /// Directions come from the surface's own sampling.
    pub const BY_SURFACE: Self = Self { images: None };

    /// Chooses by the surface's own sampling, and toward these images if there are any.
    #[inline]
    pub fn of(images: Option<&'a ImageDirections>) -> Self {
        Self { images }
    }

    /// Tells whether anything but the surface has a say.
    #[inline]
    pub(crate) fn is_mixture(self) -> bool {
        self.images.is_some()
    }

    /// The density of a unit direction that the surface draws with density `own`.
    #[inline]
    pub(crate) fn pdf(self, point: &SurfacePoint, own: SolidAnglePdf, wi: Vec3) -> SolidAnglePdf {
        let Some(images) = self.images else { return own };
        let share = SHARE * images.part();
        let aimed = point.model.smooth_chance() * images.pdf(wi).0;
        SolidAnglePdf((1.0 - share) * own.0 + share * aimed)
    }

    /// A direction for a walk that arrived from `wo`, with weight and densities as if the
    /// surface had drawn it; `u` is uniform, and its first number decides between ideal
    /// reflection, images and the rest.
    #[inline]
    pub(crate) fn sample(self, point: &SurfacePoint, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let choice = self.images.map_or(Choice::Own(u), |images| choose(images, point, u));
        match choice {
            Choice::Own(u) => point.sample(wo, u),
            Choice::Image(wi) => evaluated(point, wo, wi),
        }
    }
}

/// The source of a direction.
enum Choice {
    /// The surface, with these numbers.
    Own([f32; 3]),
    /// An image stands there.
    Image(Vec3),
}

/// Ideal reflection keeps its chance; of all else images have their share.
#[inline(never)]
fn choose(images: &ImageDirections, point: &SurfacePoint, u: [f32; 3]) -> Choice {
    let smooth = point.model.smooth_chance();
    let ideal = 1.0 - smooth;
    let share = SHARE * images.part();
    if u[0] < ideal {
        return Choice::Own(u);
    }
    // What is left of the number after each decision is uniform again.
    let rest = (u[0] - ideal) / smooth;
    if rest < share {
        Choice::Image(images.sample([rest / share, u[1], u[2]]))
    } else {
        Choice::Own([ideal + smooth * (rest - share) / (1.0 - share), u[1], u[2]])
    }
}

/// Tells whether a surface scatters into directions so wide that one may be chosen for it.
#[inline]
fn can_aim(point: &SurfacePoint) -> bool {
    let model = &point.model;
    // What passes a sheet leaves on the other side, where other images are in view.
    !model.transmits()
        && (model.has_diffuse_part() || (model.has_smooth_part() && !point.is_sharp()))
}

/// A direction as if the surface had drawn it; `None` where it sends no light.
fn evaluated(point: &SurfacePoint, wo: Vec3, wi: Vec3) -> Option<BsdfSample> {
    let scattering = point.evaluate(wo, wi);
    let kernel = scattering.f * point.cosine(Walk::FromCamera, wo, wi);
    (scattering.pdf.0 > 0.0 && !kernel.is_black()).then(|| BsdfSample {
        wi,
        weight: kernel / scattering.pdf.0,
        pdf: scattering.pdf,
        pdf_reverse: scattering.pdf_reverse,
        is_delta: false,
        eta_scale: 1.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bdpt::room;
    use crate::limits::Roulette;
    use crate::numbers::VertexNumbers;
    use crate::step::next_step_toward_light;
    use traylib_geometry::Ray;
    use traylib_math::{Sampler, warp};

    /// Points of the room that see images, each with where it is seen from.
    fn points(scene: &Scene) -> Vec<(SurfacePoint, Vec3, ImageDirections)> {
        let mut sampler = Sampler::numbered(5, 0);
        let rays = (0..400).map(|_| {
            let direction = warp::uniform_sphere(sampler.next_2d());
            Ray::new(Vec3::new(0.0, 0.1, 0.9), direction)
        });
        let found = rays.filter_map(|ray| {
            let point = scene.intersect(&ray)?;
            Some((point, -ray.direction, images_for(scene, &point)?))
        });
        found.collect()
    }

    /// The mixture reflects as much of white light, from all around and from where images stand, as
    /// the surface alone. Of the first a sum over all points is known to some 0.1 %, of the second
    /// to some 2 %: the surface seldom goes there.
    #[test]
    fn the_mixture_reflects_what_the_surface_does() {
        let scene = room();
        let points = points(&scene);
        assert!(points.len() > 100, "{}", points.len());
        let mut sampler = Sampler::numbered(6, 0);
        let mut reflected = |mixed: bool| {
            let (mut all, mut from_images, mut aimed) = (0.0, 0.0, 0);
            for (point, wo, images) in &points {
                for _ in 0..4000 {
                    let numbers = VertexNumbers::next(&mut sampler);
                    let way = TowardLight::of(mixed.then_some(images));
                    let (walk, roulette) = (Walk::FromCamera, Roulette::OFF);
                    let step = next_step_toward_light(walk, way, point, *wo, &numbers, roulette, 2);
                    let Some(step) = step else { continue };
                    let light = f64::from(step.weight.luminance());
                    all += light;
                    if !step.sample.is_delta && images.pdf(step.sample.wi).0 > 0.0 {
                        from_images += light;
                        aimed += 1;
                    }
                    assert_eq!(step.sample.pdf, expected_pdf(way, point, &step.sample, *wo));
                }
            }
            (all, from_images, aimed)
        };
        let (by_surface, by_mixture) = (reflected(false), reflected(true));
        let ratio = by_mixture.0 / by_surface.0;
        assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
        let ratio = by_mixture.1 / by_surface.1;
        assert!((ratio - 1.0).abs() < 0.1, "{ratio} {}", by_surface.2);
        // The mixture goes there much more often.
        assert!(by_mixture.2 > 3 * by_surface.2, "{} {}", by_mixture.2, by_surface.2);
    }

    /// A walk that was sent toward an image ends no sooner than one that the surface sent
    /// there: roulette goes by what the surface makes of the direction.
    #[test]
    fn roulette_goes_by_the_surface() {
        let scene = room();
        let mut sampler = Sampler::numbered(7, 0);
        let roulette = Roulette { from_edge: 2 };
        let (mut ended, mut survived) = (0, 0);
        for (point, wo, images) in &points(&scene) {
            let way = TowardLight::of(Some(images));
            for _ in 0..200 {
                let numbers = VertexNumbers::next(&mut sampler);
                let step = |roulette| {
                    let walk = Walk::FromCamera;
                    next_step_toward_light(walk, way, point, *wo, &numbers, roulette, 2)
                };
                let Some(certain) = step(Roulette::OFF) else { continue };
                if certain.sample.is_delta {
                    continue;
                }
                let wi = certain.sample.wi;
                let scattering = point.evaluate(*wo, wi);
                let cosine = point.cosine(Walk::FromCamera, *wo, wi);
                let own_weight = scattering.f * (cosine / scattering.pdf.0);
                let chance = own_weight.max_band().clamp(0.05, 1.0);
                // Not at the very threshold.
                if (numbers.roulette - chance).abs() < 1e-3 {
                    continue;
                }
                let found = step(roulette);
                assert_eq!(found.is_some(), numbers.roulette < chance, "{chance}");
                if let Some(found) = found {
                    let ratio = certain.weight.max_band() / found.weight.max_band();
                    assert!((ratio / chance - 1.0).abs() < 1e-4, "{ratio} {chance}");
                }
                ended += u32::from(found.is_none());
                survived += u32::from(found.is_some());
            }
        }
        assert!(ended > 1000 && survived > 1000, "{ended} {survived}");
    }

    /// The density of a drawn direction from the BSDF alone.
    fn expected_pdf(
        way: TowardLight<'_>,
        point: &SurfacePoint,
        sample: &BsdfSample,
        wo: Vec3,
    ) -> SolidAnglePdf {
        if sample.is_delta {
            return sample.pdf;
        }
        way.pdf(point, point.evaluate(wo, sample.wi).pdf, sample.wi)
    }
}
