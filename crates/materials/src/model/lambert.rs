//! The ideal diffuse surface.

use crate::error::{Error, check_reflectance};
use crate::scattering::{BsdfSample, Scattering};
use std::f32::consts::FRAC_1_PI;
use traylib_math::{Rgb, SolidAnglePdf, Vec2, Vec3, warp};

/// Reflects the same radiance into all directions: f = kd/π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    reflectance: Rgb,
}

impl Lambert {
    /// Absorbs all light.
    pub const BLACK: Self = Self { reflectance: Rgb::BLACK };

    /// A surface that reflects `reflectance` (kd) of what arrives.
    ///
    /// # Errors
    /// [`Error::Reflectance`] outside [0, 1].
    pub fn new(reflectance: Rgb) -> Result<Self, Error> {
        check_reflectance("reflectance", reflectance)?;
        Ok(Self { reflectance })
    }

    /// The part of the light that is reflected, kd.
    pub fn reflectance(&self) -> Rgb {
        self.reflectance
    }

    /// A surface with another reflectance, for textures: each band is brought
    /// into [0, 1].
    #[must_use]
    pub fn with_reflectance(&self, reflectance: Rgb) -> Self {
        Self { reflectance: reflectance.saturated() }
    }

    /// Tells whether nothing is reflected at all.
    pub(crate) fn is_black(&self) -> bool {
        self.reflectance.is_black()
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let (cos_o, cos_i) = (normal.dot(wo), normal.dot(wi));
        if cos_o <= 0.0 || cos_i <= 0.0 {
            return Scattering::NONE;
        }
        Scattering {
            f: self.reflectance * FRAC_1_PI,
            pdf: SolidAnglePdf(warp::cosine_hemisphere_pdf(cos_i)),
            pdf_reverse: SolidAnglePdf(warp::cosine_hemisphere_pdf(cos_o)),
        }
    }

    #[inline]
    pub(crate) fn sample(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let wi = warp::cosine_hemisphere(normal, Vec2::new(u[1], u[2]));
        let (cos_o, cos_i) = (normal.dot(wo), normal.dot(wi));
        if cos_o <= 0.0 || cos_i <= 0.0 || self.is_black() {
            return None;
        }
        Some(BsdfSample {
            wi,
            weight: self.reflectance,
            pdf: SolidAnglePdf(warp::cosine_hemisphere_pdf(cos_i)),
            pdf_reverse: SolidAnglePdf(warp::cosine_hemisphere_pdf(cos_o)),
            is_delta: false,
            eta_scale: 1.0,
        })
    }
}
