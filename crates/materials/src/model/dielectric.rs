//! Smooth glass.

use super::phong::mirror_direction;
use crate::error::Error;
use crate::scattering::BsdfSample;
use traylib_math::{Rgb, SolidAnglePdf, Vec3};

/// The smooth boundary of a clear solid with an index of refraction: reflects by
/// Fresnel's equations for unpolarised light, and refracts the rest by Snell's
/// law. Nothing is absorbed.
///
/// The front of the surface is outside of the solid. Both parts are ideal, so
/// that only [`sample`](crate::SurfaceModel::sample) finds them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Index of refraction of the far side over that of the side of `wo`.
    relative_index: f32,
}

impl Dielectric {
    /// The boundary of a solid whose index of refraction is `index` times that
    /// of what is around it.
    ///
    /// # Errors
    /// [`Error::Index`] unless it is between 0.1 and 10 and not 1, at which there
    /// is nothing to be seen.
    pub fn new(index: f32) -> Result<Self, Error> {
        if (0.1..=10.0).contains(&index) && index != 1.0 {
            Ok(Self { relative_index: index })
        } else {
            Err(Error::Index(index))
        }
    }

    /// The index of refraction of the solid over that of what is around it.
    pub fn index(&self) -> f32 {
        self.relative_index
    }

    /// Returns the boundary seen from inside of the solid.
    pub(crate) fn seen_from_behind(self) -> Self {
        Self { relative_index: self.relative_index.recip() }
    }

    /// Reflects or refracts with the chance of Fresnel's reflectance: it is the
    /// same for the way back, so that nothing but the choice is left in the
    /// weight.
    #[inline]
    pub(crate) fn sample(self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let cos_o = normal.dot(wo);
        if cos_o <= 0.0 {
            return None;
        }
        let (reflectance, cos_t) = self.fresnel(cos_o);
        if u[0] < reflectance {
            let wi = mirror_direction(normal, wo);
            return (normal.dot(wi) > 0.0).then(|| ideal(wi, reflectance, 1.0));
        }
        let eta = self.relative_index.recip();
        let wi = (normal * (eta * cos_o - cos_t) - wo * eta).normalize();
        (normal.dot(wi) < 0.0).then(|| ideal(wi, 1.0 - reflectance, eta * eta))
    }

    /// Reflectance for unpolarised light that arrives with this cosine, and the
    /// cosine of the refracted direction (0 where all is reflected).
    ///
    /// Born and Wolf, *Principles of Optics*, section 1.5.
    fn fresnel(self, cos_o: f32) -> (f32, f32) {
        let eta = self.relative_index;
        let sin2_t = (1.0 - cos_o) * (1.0 + cos_o) / (eta * eta);
        if sin2_t >= 1.0 {
            return (1.0, 0.0);
        }
        let cos_t = (1.0 - sin2_t).sqrt();
        let parallel = (eta * cos_o - cos_t) / (eta * cos_o + cos_t);
        let perpendicular = (cos_o - eta * cos_t) / (cos_o + eta * cos_t);
        (0.5 * (parallel * parallel + perpendicular * perpendicular), cos_t)
    }
}

fn ideal(wi: Vec3, chance: f32, eta_scale: f32) -> BsdfSample {
    let pdf = SolidAnglePdf(chance);
    BsdfSample { wi, weight: Rgb::WHITE, pdf, pdf_reverse: pdf, is_delta: true, eta_scale }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slanted(cosine: f32) -> Vec3 {
        Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine)
    }

    #[test]
    fn straight_on_it_reflects_what_the_books_say() {
        let glass = Dielectric::new(1.5).unwrap();
        assert!((glass.fresnel(1.0).0 - 0.04).abs() < 1e-6);
        // At Brewster's angle, tan θ = n, half of the perpendicular light alone.
        let brewster = 1.5_f32.atan();
        let perpendicular = (1.0 - 2.0 * brewster.cos().powi(2)).powi(2);
        let (reflectance, _) = glass.fresnel(brewster.cos());
        assert!((reflectance - 0.5 * perpendicular).abs() < 1e-6, "{reflectance}");
    }

    #[test]
    fn the_way_back_is_the_same_way_with_the_same_chance() {
        let glass = Dielectric::new(1.5).unwrap();
        for cosine in [1.0, 0.9, 0.5, 0.2, 0.01] {
            let wo = slanted(cosine);
            let forth = glass.sample(Vec3::Z, wo, [1.0 - f32::EPSILON, 0.0, 0.0]).unwrap();
            let sine = (1.0 - forth.wi.z * forth.wi.z).sqrt();
            assert!((wo.x - 1.5 * sine).abs() < 1e-6, "Snell: {cosine}");
            let inside = glass.seen_from_behind();
            let back = inside.sample(-Vec3::Z, forth.wi, [1.0 - f32::EPSILON, 0.0, 0.0]).unwrap();
            // Close to grazing a rounding of the direction weighs more.
            assert!((back.wi - wo).length() < 1e-6 / cosine, "{cosine}");
            assert!((back.pdf.0 - forth.pdf.0).abs() < 1e-6 / cosine, "{cosine}");
            assert!((back.eta_scale * forth.eta_scale - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn beyond_the_critical_angle_all_is_reflected() {
        let inside = Dielectric::new(1.5).unwrap().seen_from_behind();
        let wo = slanted(0.7);
        let sample = inside.sample(Vec3::Z, wo, [1.0 - f32::EPSILON, 0.0, 0.0]).unwrap();
        assert_eq!((sample.pdf.0, sample.wi), (1.0, Vec3::new(-wo.x, 0.0, wo.z).normalize()));
    }

    #[test]
    fn indices_that_make_no_boundary_are_refused() {
        for index in [0.0, 1.0, -1.5, 11.0, f32::NAN] {
            assert!(matches!(Dielectric::new(index), Err(Error::Index(_))), "{index}");
        }
    }
}
