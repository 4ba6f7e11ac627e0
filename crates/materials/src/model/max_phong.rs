//! A metal lobe that stays bright at grazing angles.

use super::phong::{half_square_off_mirror, mirror_direction};
use crate::error::{Error, check_exponent, check_reflectance};
use crate::scattering::Scattering;
use std::f32::consts::TAU;
use traylib_math::{Rgb, SolidAnglePdf, Vec2, Vec3, warp};

/// Max-Phong: f = ks·(n+1)/(2π)·cosⁿα / max(cosθi, cosθo).
///
/// Reciprocal, reflects no more than ks, and tends to the ideal mirror as the
/// exponent grows, which modified Phong does not.
///
/// Neumann, Neumann and Szirmay-Kalos, *Compact Metallic Reflectance Models*,
/// 1999.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxPhong {
    specular: Rgb,
    exponent: f32,
}

impl MaxPhong {
    /// A metal that reflects up to `specular` (ks) with exponent n.
    ///
    /// # Errors
    /// [`Error::Reflectance`] outside [0, 1], [`Error::Exponent`] outside
    /// [0, 10⁶].
    pub fn new(specular: Rgb, exponent: f32) -> Result<Self, Error> {
        check_reflectance("specular", specular)?;
        check_exponent(exponent)?;
        Ok(Self { specular, exponent })
    }

    /// The specular part ks.
    pub fn specular(&self) -> Rgb {
        self.specular
    }

    /// The exponent n.
    pub fn exponent(&self) -> f32 {
        self.exponent
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let (cos_o, cos_i) = (normal.dot(wo), normal.dot(wi));
        if cos_o <= 0.0 || cos_i <= 0.0 {
            return Scattering::NONE;
        }
        let half_square = half_square_off_mirror(normal, wo, wi);
        let lobe = (self.exponent + 1.0) / TAU * warp::cosine_power(half_square, self.exponent);
        Scattering {
            f: self.specular * (lobe / cos_o.max(cos_i)),
            pdf: SolidAnglePdf(lobe),
            pdf_reverse: SolidAnglePdf(lobe),
        }
    }

    #[inline]
    pub(crate) fn direction(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Vec3 {
        let axis = mirror_direction(normal, wo);
        warp::cosine_power_lobe(axis, self.exponent, Vec2::new(u[1], u[2]))
    }
}
