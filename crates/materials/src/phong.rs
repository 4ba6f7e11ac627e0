//! The modified Phong model.

use crate::error::{Error, check_energy, check_exponent};
use crate::lottery::specular_chance;
use crate::scattering::Scattering;
use std::f32::consts::{FRAC_1_PI, TAU};
use traylib_math::{Defect, Rgb, SolidAnglePdf, Vec2, Vec3, planted, warp};

/// Modified Phong: f = kd/π + ks·(n+2)/(2π)·cosⁿα, α the angle between `wi` and
/// the mirror direction of `wo`.
///
/// Reciprocal, and reflects no more than kd + ks. A sharp lobe is not a mirror:
/// its albedo falls off as the cosine of the angle of incidence. [`MaxPhong`] and
/// [`Mirror`] do not.
///
/// Lafortune and Willems, *Using the modified Phong reflectance model for
/// physically based rendering*, 1994.
///
/// [`MaxPhong`]: crate::MaxPhong
/// [`Mirror`]: crate::Mirror
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    diffuse: Rgb,
    specular: Rgb,
    exponent: f32,
    lobe_chance: f32,
}

impl Phong {
    /// A surface with diffuse part kd, specular part ks and exponent n.
    ///
    /// # Errors
    /// [`Error::Reflectance`] or [`Error::Energy`] if kd + ks exceeds one,
    /// [`Error::Exponent`] outside [0, 10⁶].
    pub fn new(diffuse: Rgb, specular: Rgb, exponent: f32) -> Result<Self, Error> {
        check_energy(("diffuse", diffuse), ("specular", specular))?;
        check_exponent(exponent)?;
        let lobe_chance = specular_chance(diffuse, specular);
        Ok(Self { diffuse, specular, exponent, lobe_chance })
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let (cos_o, cos_i) = (normal.dot(wo), normal.dot(wi));
        if cos_o <= 0.0 || cos_i <= 0.0 {
            return Scattering::NONE;
        }
        let n = self.exponent;
        let lobe = warp::cosine_power(half_square_off_mirror(normal, wo, wi), n) / TAU;
        let mixture = |cosine| {
            let diffuse = (1.0 - self.lobe_chance) * warp::cosine_hemisphere_pdf(cosine);
            SolidAnglePdf(self.lobe_chance * (n + 1.0) * lobe + diffuse)
        };
        Scattering {
            f: self.diffuse * FRAC_1_PI + self.specular * ((n + 2.0) * lobe),
            pdf: mixture(cos_i),
            pdf_reverse: mixture(cos_o),
        }
    }

    /// A direction from the lobe or the diffuse part; it may lie below the
    /// surface, where [`evaluate`](Self::evaluate) finds nothing: the density
    /// integrates to less than one by just that part.
    #[inline]
    pub(crate) fn direction(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Vec3 {
        let square = Vec2::new(u[1], u[2]);
        if u[0] < self.lobe_chance {
            let around_normal = planted(Defect::LobeAroundNormal);
            let axis = if around_normal { normal } else { mirror_direction(normal, wo) };
            warp::cosine_power_lobe(axis, self.exponent, square)
        } else {
            warp::cosine_hemisphere(normal, square)
        }
    }
}

/// The direction into which a mirror sends light from `wo`.
#[inline]
pub(crate) fn mirror_direction(normal: Vec3, wo: Vec3) -> Vec3 {
    (2.0 * normal.dot(wo) * normal - wo).normalize()
}

/// Half the squared distance between `wi` and the mirror direction of `wo`, in
/// a form that is exactly the same when the two are exchanged: what is left of
/// wi + wo beside the normal, and the difference of their cosines.
#[inline]
pub(crate) fn half_square_off_mirror(normal: Vec3, wo: Vec3, wi: Vec3) -> f32 {
    let sum = wo + wi;
    let tangential = sum - normal.dot(sum) * normal;
    let cosines = normal.dot(wo) - normal.dot(wi);
    0.5 * (tangential.length_squared() + cosines * cosines)
}
