//! The closed set of surface models.

mod dielectric;
mod lambert;
mod max_phong;
mod mirror;
mod phong;
mod sheet;

pub use dielectric::Dielectric;
pub use lambert::Lambert;
pub use max_phong::MaxPhong;
pub use mirror::Mirror;
pub use phong::Phong;
pub use sheet::Sheet;

use crate::{BsdfSample, Scattering};
use traylib_math::{Rgb, Vec3};

/// A model of how a surface scatters light. It is small and `Copy`; a scene keeps one a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceModel {
    /// Ideal diffuse.
    Lambert(Lambert),
    /// Diffuse with a glossy lobe.
    Phong(Phong),
    /// Metal lobe.
    MaxPhong(MaxPhong),
    /// Ideal mirror, perhaps with a diffuse part.
    Mirror(Mirror),
    /// Thin sheet that scatters light to both of its sides.
    Sheet(Sheet),
    /// Boundary of clear glass.
    Dielectric(Dielectric),
}

impl SurfaceModel {
    /// The BSDF and the densities of a pair of directions, without the part
    /// that only an ideal reflection or refraction carries. Zero unless `wo` is
    /// above the surface, and `wi` too if the surface [`transmits`](Self::transmits)
    /// nothing.
    #[inline]
    pub fn evaluate(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Scattering {
        match self {
            Self::Lambert(m) => m.evaluate(normal, wo, wi),
            Self::Phong(m) => m.evaluate(normal, wo, wi),
            Self::MaxPhong(m) => m.evaluate(normal, wo, wi),
            Self::Mirror(m) => m.evaluate(normal, wo, wi),
            Self::Sheet(m) => m.evaluate(normal, wo, wi),
            Self::Dielectric(_) => Scattering::NONE,
        }
    }

    /// A direction for light from `wo`, drawn with the density that
    /// [`evaluate`](Self::evaluate) states: `u[0]` chooses the lobe, the others
    /// the direction. `None` where the light is absorbed, or the lobe dipped
    /// below the surface: a sample with value zero, not to be drawn again.
    #[inline]
    pub fn sample(&self, normal: Vec3, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        match self {
            Self::Lambert(m) => m.sample(normal, wo, u),
            Self::Mirror(m) => m.sample(normal, wo, u),
            Self::Dielectric(m) => m.sample(normal, wo, u),
            Self::Phong(m) => self.weigh(normal, wo, m.direction(normal, wo, u)),
            Self::MaxPhong(m) => self.weigh(normal, wo, m.direction(normal, wo, u)),
            Self::Sheet(m) => self.weigh(normal, wo, m.direction(normal, wo, u)?),
        }
    }

    /// The sample that a drawn direction makes. BRDF and density come from the
    /// same stored direction: a sharp lobe would not forgive less.
    fn weigh(&self, normal: Vec3, wo: Vec3, wi: Vec3) -> Option<BsdfSample> {
        let Scattering { f, pdf, pdf_reverse } = self.evaluate(normal, wo, wi);
        let weight = f * (normal.dot(wi).abs() / pdf.0);
        (pdf.0 > 0.0 && !weight.is_black()).then_some(BsdfSample {
            wi,
            weight,
            pdf,
            pdf_reverse,
            is_delta: false,
            eta_scale: 1.0,
        })
    }

    /// Tells whether [`evaluate`](Self::evaluate) can be anything but zero: whether a
    /// connection to this surface can carry light.
    pub fn has_smooth_part(&self) -> bool {
        match self {
            Self::Lambert(m) => !m.is_black(),
            Self::Phong(_) | Self::MaxPhong(_) | Self::Sheet(_) => true,
            Self::Mirror(m) => m.has_smooth_part(),
            Self::Dielectric(_) => false,
        }
    }

    /// Tells whether part of the light is reflected or refracted ideally.
    pub fn has_delta_part(&self) -> bool {
        match self {
            Self::Mirror(m) => m.has_delta_part(),
            Self::Dielectric(_) => true,
            Self::Lambert(_) | Self::Phong(_) | Self::MaxPhong(_) | Self::Sheet(_) => false,
        }
    }

    /// The exponent of the lobe around the mirror direction, infinite where that is an ideal
    /// reflection or refraction; `None` of a surface that has none.
    pub fn mirror_exponent(&self) -> Option<f32> {
        match self {
            Self::Phong(m) => m.lobe_exponent(),
            Self::MaxPhong(m) => Some(m.exponent()),
            Self::Mirror(m) => m.has_delta_part().then_some(f32::INFINITY),
            Self::Dielectric(_) => Some(f32::INFINITY),
            Self::Lambert(_) | Self::Sheet(_) => None,
        }
    }

    /// The part of the light that is reflected ideally, from whichever direction it comes; `None`
    /// of a surface that reflects nothing ideally, and of glass, where it depends on the direction.
    pub fn mirror_reflectance(&self) -> Option<Rgb> {
        match self {
            Self::Mirror(m) => m.has_delta_part().then_some(m.reflectance()),
            Self::Lambert(_)
            | Self::Phong(_)
            | Self::MaxPhong(_)
            | Self::Sheet(_)
            | Self::Dielectric(_) => None,
        }
    }

    /// The chance with which [`sample`](Self::sample) reflects ideally, where
    /// [`mirror_reflectance`](Self::mirror_reflectance) knows of it.
    pub fn mirror_chance(&self) -> Option<f32> {
        match self {
            Self::Mirror(m) => m.has_delta_part().then_some(m.delta_chance()),
            Self::Lambert(_)
            | Self::Phong(_)
            | Self::MaxPhong(_)
            | Self::Sheet(_)
            | Self::Dielectric(_) => None,
        }
    }

    /// Tells whether some of the light is scattered into all directions.
    pub fn has_diffuse_part(&self) -> bool {
        match self {
            Self::Lambert(m) => !m.is_black(),
            Self::Phong(m) => !m.diffuse().is_black(),
            Self::Mirror(m) => m.has_smooth_part(),
            Self::Sheet(_) => true,
            Self::MaxPhong(_) | Self::Dielectric(_) => false,
        }
    }

    /// Tells whether [`sample`](Self::sample) has a choice of lobes.
    pub fn chooses_lobe(&self) -> bool {
        match self {
            Self::Phong(m) => m.lobe_exponent().is_some() && !m.diffuse().is_black(),
            Self::Mirror(m) => m.has_delta_part() && m.has_smooth_part(),
            Self::Sheet(_) | Self::Dielectric(_) => true,
            Self::Lambert(_) | Self::MaxPhong(_) => false,
        }
    }

    /// The chance that [`sample`](Self::sample) draws no ideal reflection or refraction: what
    /// the densities of [`evaluate`](Self::evaluate) sum up to, but for what dips below the
    /// surface.
    pub fn smooth_chance(&self) -> f32 {
        match self {
            Self::Mirror(m) => m.smooth_chance(),
            Self::Dielectric(_) => 0.0,
            Self::Lambert(_) | Self::Phong(_) | Self::MaxPhong(_) | Self::Sheet(_) => 1.0,
        }
    }

    /// Tells whether [`evaluate`](Self::evaluate) can be anything but zero for `wi`
    /// below the surface.
    pub fn transmits(&self) -> bool {
        match self {
            Self::Sheet(_) => true,
            Self::Lambert(_)
            | Self::Phong(_)
            | Self::MaxPhong(_)
            | Self::Mirror(_)
            | Self::Dielectric(_) => false,
        }
    }

    /// The model with other colours in place of its diffuse and its specular part, where
    /// pictures can show.
    pub(crate) fn with_colours(
        self,
        diffuse: impl Fn(Rgb) -> Rgb,
        specular: impl Fn(Rgb) -> Rgb,
    ) -> Self {
        match self {
            Self::Lambert(m) => Self::Lambert(m.with_reflectance(diffuse(m.reflectance()))),
            Self::Phong(m) => {
                Self::Phong(m.with_parts(diffuse(m.diffuse()), specular(m.specular())))
            }
            other
            @ (Self::MaxPhong(_) | Self::Mirror(_) | Self::Sheet(_) | Self::Dielectric(_)) => other,
        }
    }

    /// The model of a surface whose front and back differ, seen from its back.
    #[must_use]
    pub fn seen_from_behind(self) -> Self {
        match self {
            Self::Dielectric(m) => Self::Dielectric(m.seen_from_behind()),
            other @ (Self::Lambert(_)
            | Self::Phong(_)
            | Self::MaxPhong(_)
            | Self::Mirror(_)
            | Self::Sheet(_)) => other,
        }
    }
}

#[cfg(test)]
mod tests;
