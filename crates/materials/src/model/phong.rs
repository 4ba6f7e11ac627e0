//! The modified Phong model.

use crate::error::{Error, check_energy, check_exponent};
use crate::lobe_choice::specular_chance;
use crate::scattering::Scattering;
use std::f32::consts::{FRAC_1_PI, TAU};
use traylib_math::{Rgb, SolidAnglePdf, Vec2, Vec3, warp};

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

    /// Returns the surface with another diffuse and specular part, for textures:
    /// each band is brought into [0, 1] and both parts are scaled down where
    /// they would reflect more than arrives.
    #[must_use]
    pub fn with_parts(&self, diffuse: Rgb, specular: Rgb) -> Self {
        let [diffuse, specular] = [diffuse, specular].map(Rgb::saturated);
        let excess = (diffuse + specular).max_band().max(1.0);
        let (diffuse, specular) = (diffuse / excess, specular / excess);
        let lobe_chance = specular_chance(diffuse, specular);
        Self { diffuse, specular, exponent: self.exponent, lobe_chance }
    }

    /// The diffuse part kd.
    pub fn diffuse(&self) -> Rgb {
        self.diffuse
    }

    /// The specular part ks.
    pub fn specular(&self) -> Rgb {
        self.specular
    }

    /// The exponent n of the specular part, also where that is black.
    pub fn exponent(&self) -> f32 {
        self.exponent
    }

    /// The exponent of the specular part, if there is one.
    pub(crate) fn lobe_exponent(&self) -> Option<f32> {
        (!self.specular.is_black()).then_some(self.exponent)
    }

    /// No more than this is reflected, from whatever direction.
    pub(crate) fn albedo_bound(&self) -> Rgb {
        self.diffuse + self.specular
    }

    #[inline]
    pub(crate) fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let cosines = [normal.dot(wo), normal.dot(wi)];
        self.scattering(cosines, half_square_off_mirror(normal, wo, wi))
    }

    /// Evaluates it for light that passes to the other side, with the lobe about the
    /// straight direction: as if `wi` were mirrored in the surface.
    #[inline]
    pub(crate) fn evaluate_through(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        let cosines = [normal.dot(wo), -normal.dot(wi)];
        self.scattering(cosines, half_square_off_straight(normal, wo, wi))
    }

    /// For these cosines at `wo` and `wi`, and half the squared distance to the
    /// middle of the lobe.
    #[inline]
    fn scattering(&self, [cos_o, cos_i]: [f32; 2], half_square: f32) -> Scattering {
        if cos_o <= 0.0 || cos_i <= 0.0 {
            return Scattering::NONE;
        }
        let n = self.exponent;
        let is_diffuse = self.lobe_chance == 0.0;
        let lobe = if is_diffuse { 0.0 } else { warp::cosine_power(half_square, n) / TAU };
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
            warp::cosine_power_lobe(mirror_direction(normal, wo), self.exponent, square)
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
    half_square(normal, wo + wi, normal.dot(wo) - normal.dot(wi))
}

/// Half the squared distance between `wi` and −`wo`, in the same form.
#[inline]
fn half_square_off_straight(normal: Vec3, wo: Vec3, wi: Vec3) -> f32 {
    half_square(normal, wo + wi, normal.dot(wo) + normal.dot(wi))
}

#[inline]
fn half_square(normal: Vec3, sum: Vec3, cosines: f32) -> f32 {
    let tangential = sum - normal.dot(sum) * normal;
    0.5 * (tangential.length_squared() + cosines * cosines)
}
