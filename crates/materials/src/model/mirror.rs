//! The ideal mirror.

use super::lambert::Lambert;
use super::phong::mirror_direction;
use crate::error::{Error, check_energy};
use crate::lobe_choice::specular_chance;
use crate::scattering::{BsdfSample, Scattering};
use traylib_math::{Rgb, SolidAnglePdf, Vec3};

/// Reflects `reflectance` (km) into the mirror direction alone, and optionally
/// a diffuse part.
///
/// The mirror part has no density per steradian: only
/// [`sample`](crate::SurfaceModel::sample) finds it, and the smooth densities
/// carry the chance that it was not chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    reflectance: Rgb,
    diffuse: Lambert,
    delta_chance: f32,
}

impl Mirror {
    /// A mirror with a diffuse part (black for none).
    ///
    /// # Errors
    /// [`Error::Reflectance`] or [`Error::Energy`] if the parts exceed one.
    pub fn new(reflectance: Rgb, diffuse: Rgb) -> Result<Self, Error> {
        check_energy(("reflectance", reflectance), ("diffuse", diffuse))?;
        let delta_chance = specular_chance(diffuse, reflectance);
        Ok(Self { reflectance, diffuse: Lambert::new(diffuse)?, delta_chance })
    }

    /// Tells whether a connection can find light here.
    pub(crate) fn has_smooth_part(&self) -> bool {
        !self.diffuse.is_black()
    }

    /// The chance that the diffuse part is sampled.
    pub(crate) fn smooth_chance(&self) -> f32 {
        1.0 - self.delta_chance
    }

    /// Tells whether anything goes into the mirror direction.
    pub(crate) fn has_delta_part(&self) -> bool {
        self.delta_chance > 0.0
    }

    /// The chance that the mirror part is sampled.
    pub(crate) fn delta_chance(&self) -> f32 {
        self.delta_chance
    }

    /// Returns the part of the light that goes into the mirror direction.
    pub fn reflectance(&self) -> Rgb {
        self.reflectance
    }

    /// The part of the light that is reflected diffusely.
    pub fn diffuse(&self) -> Rgb {
        self.diffuse.reflectance()
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let Scattering { f, pdf, pdf_reverse } = self.diffuse.evaluate(normal, wo, wi);
        let chance = self.smooth_chance();
        Scattering {
            f,
            pdf: SolidAnglePdf(chance * pdf.0),
            pdf_reverse: SolidAnglePdf(chance * pdf_reverse.0),
        }
    }

    #[inline]
    pub(crate) fn sample(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let chance = self.smooth_chance();
        if u[0] >= self.delta_chance {
            let sample = self.diffuse.sample(normal, wo, u)?;
            return Some(BsdfSample {
                weight: sample.weight / chance,
                pdf: SolidAnglePdf(chance * sample.pdf.0),
                pdf_reverse: SolidAnglePdf(chance * sample.pdf_reverse.0),
                ..sample
            });
        }
        let wi = mirror_direction(normal, wo);
        (normal.dot(wo) > 0.0 && normal.dot(wi) > 0.0).then_some(BsdfSample {
            wi,
            weight: self.reflectance / self.delta_chance,
            pdf: SolidAnglePdf(self.delta_chance),
            pdf_reverse: SolidAnglePdf(self.delta_chance),
            is_delta: true,
            eta_scale: 1.0,
        })
    }
}
