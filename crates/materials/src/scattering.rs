//! The answers of a surface model: values, samples and densities.

use traylib_math::{Rgb, SolidAnglePdf, Vec3};

/// The BSDF and the densities of a pair of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattering {
    /// The BSDF, in 1/sr, without any cosine. The same when the directions are
    /// exchanged.
    pub f: Rgb,
    /// Density of [`sample`](crate::SurfaceModel::sample) returning `wi`, given
    /// `wo`.
    pub pdf: SolidAnglePdf,
    /// Density of it returning `wo`, given `wi`: the same walk from the other
    /// end.
    pub pdf_reverse: SolidAnglePdf,
}

impl Scattering {
    /// No light, and no chance to sample it.
    pub const NONE: Self =
        Self { f: Rgb::BLACK, pdf: SolidAnglePdf(0.0), pdf_reverse: SolidAnglePdf(0.0) };
}

/// A direction that a surface picked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// The direction, unit, leaving the surface.
    pub wi: Vec3,
    /// f·cosθ/pdf, with the cosine at `wi`; for a mirror, reflectance over the
    /// chance to choose it.
    pub weight: Rgb,
    /// Density of `wi` given `wo`; for a mirror the chance to choose it.
    pub pdf: SolidAnglePdf,
    /// Density of `wo` given `wi`; for a mirror the chance to choose it.
    pub pdf_reverse: SolidAnglePdf,
    /// True if this was an ideal reflection or refraction, which no connection can find.
    pub is_delta: bool,
    /// The factor of refraction on radiance on its way from the medium of
    /// `wi` into that of `wo`, (n_o/n_i)²; one for all else. It is not in
    /// `weight`: a walk from a light carries power, which is not changed.
    pub eta_scale: f32,
}
