//! The point at which a ray met a surface: the one place that knows both its position and its
//! material.

use crate::LightId;
use crate::light::sky;
use traylib_geometry::SurfaceSite;
use traylib_materials::{BsdfSample, Lambert, Scattering, SurfaceModel};
use traylib_math::{Rgb, Vec3};

/// A lobe of this exponent or more shows images: it is 6 degrees wide.
pub(crate) const SHARP: f32 = 1e3;

/// The end of the path that a walk started from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// From the camera toward the lights.
    FromCamera,
    /// From a light toward the camera.
    FromLight,
}

/// A point on a surface, seen from the side that `wo` came from (the paper's
/// `Surface`).
///
/// Directions `wo` and `wi` are unit and leave the surface; `wo` leads back to
/// where the walk came from.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// Position, its rounding error, and the *front* normal of the geometry.
    pub site: SurfaceSite,
    /// Geometric normal N_g on the side of `wo`.
    pub normal: Vec3,
    /// Shading normal N_s, turned over together with N_g.
    pub shading_normal: Vec3,
    /// The BSDF of the surface here, seen from this side.
    pub model: SurfaceModel,
    /// The part of the surface that is there, in 0..1.
    pub opacity: f32,
    /// The part of the light that passes straight through.
    pub through: Rgb,
    /// The lamp this surface is.
    pub light: Option<LightId>,
    /// The index of the surface in the scene.
    pub surface: u32,
}

/// The number of no surface.
const SKY: u32 = u32::MAX;

impl SurfacePoint {
    /// The sky in this unit direction.
    pub(crate) fn of_sky(toward: Vec3, light: LightId) -> Self {
        let site = sky::site(toward);
        let (normal, shading_normal) = (site.normal, site.normal);
        let model = SurfaceModel::Lambert(Lambert::BLACK);
        let (opacity, through, light) = (1.0, Rgb::BLACK, Some(light));
        Self { site, normal, shading_normal, model, opacity, through, light, surface: SKY }
    }

    /// Tells whether it is a point of the sky, which is at no place: its position is the unit
    /// direction there, and its normal leads back.
    #[inline]
    pub fn is_sky(&self) -> bool {
        self.surface == SKY
    }

    /// BSDF and densities for a pair of directions. Zero unless `wo` is on the
    /// side of the geometric *and* of the shading normal and `wi` on the same
    /// side of both, in every technique alike.
    #[inline]
    pub fn evaluate(&self, wo: Vec3, wi: Vec3) -> Scattering {
        if self.normal.dot(wo) <= 0.0 || !self.may_scatter_to(wi) || !self.agree(wi) {
            return Scattering::NONE;
        }
        self.model.evaluate(self.shading_normal, wo, wi)
    }

    /// Tells whether light can go on in this direction, of any length: on the side of
    /// `wo`, or through.
    #[inline]
    pub fn may_scatter_to(&self, wi: Vec3) -> bool {
        self.normal.dot(wi) > 0.0 || self.model.transmits()
    }

    /// Tells whether a direction is on the same side of both normals.
    #[inline]
    fn agree(&self, wi: Vec3) -> bool {
        self.normal.dot(wi) * self.shading_normal.dot(wi) > 0.0
    }

    /// A direction to go on in; its weight is that of a walk from the camera, but
    /// for refraction's compression.
    // The hottest call of a walk: left to itself the compiler makes a function of it.
    #[expect(clippy::inline_always, reason = "worth 1 % of a rendering")]
    #[inline(always)]
    pub fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let sample = self.model.sample(self.shading_normal, wo, u)?;
        (self.normal.dot(wo) > 0.0 && self.agree(sample.wi)).then_some(sample)
    }

    /// Returns the factor on the BRDF when a walk from `wo` goes on to `wi`.
    ///
    /// The oriented kernel of a vertex is f·cos_s(w_l)·cos_g(w_e): the light side
    /// with the shading normal, the eye side with the geometric one. The cosine
    /// of the arriving edge was divided out by that edge's density, always a
    /// geometric one, which leaves cos_s(wi) for a walk from the camera and
    /// cos_g(wi)·cos_s(wo)/cos_g(wo) for one from a light.
    ///
    /// Veach, *Robust Monte Carlo Methods for Light Transport Simulation*, 1997,
    /// section 5.3.
    #[inline]
    pub fn cosine(&self, walk: Walk, wo: Vec3, wi: Vec3) -> f32 {
        match walk {
            Walk::FromCamera => self.shading_normal.dot(wi).abs(),
            Walk::FromLight => {
                self.normal.dot(wi).abs() * self.shading_normal.dot(wo).abs()
                    / self.normal.dot(wo).abs()
            }
        }
    }

    /// The weight of a sample for a walk from either end.
    #[inline]
    pub fn walk_weight(&self, walk: Walk, wo: Vec3, sample: &BsdfSample) -> Rgb {
        match walk {
            Walk::FromCamera => sample.weight,
            Walk::FromLight => {
                let adjoint =
                    self.cosine(walk, wo, sample.wi) / self.cosine(Walk::FromCamera, wo, sample.wi);
                sample.weight * adjoint
            }
        }
    }

    /// Tells whether it shows images: whether light that it reflects ideally or by a narrow lobe
    /// stays together.
    #[inline]
    pub fn is_sharp(&self) -> bool {
        self.model.mirror_exponent().is_some_and(|exponent| exponent >= SHARP)
    }

    /// Tells whether `wo` is on the front side, the only one that emits.
    pub fn is_front(&self) -> bool {
        self.normal == self.site.normal
    }
}
