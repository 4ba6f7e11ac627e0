//! Where a ray met a surface: the one place that knows both where it is and
//! what it is made of.

use crate::scene::LightId;
use traylib_geometry::SurfaceSite;
use traylib_materials::{BsdfSample, Scattering, SurfaceModel};
use traylib_math::{Defect, Rgb, Vec3, planted};

/// Which end of the path a walk started from.
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
pub struct SurfacePoint<'scene> {
    /// Position, its rounding error, and the *front* normal of the geometry.
    pub site: SurfaceSite,
    /// Geometric normal N_g on the side of `wo`.
    pub normal: Vec3,
    /// Shading normal N_s, turned over together with N_g.
    pub shading_normal: Vec3,
    /// What the surface is made of.
    pub model: &'scene SurfaceModel,
    /// The lamp this surface is.
    pub light: Option<LightId>,
}

impl SurfacePoint<'_> {
    /// BRDF and densities for a pair of directions. Zero unless both are on the
    /// side of the geometric *and* of the shading normal, in every technique
    /// alike.
    #[inline]
    pub fn evaluate(&self, wo: Vec3, wi: Vec3) -> Scattering {
        if self.normal.dot(wo) <= 0.0 || self.normal.dot(wi) <= 0.0 {
            return Scattering::NONE;
        }
        self.model.evaluate(self.shading_normal, wo, wi)
    }

    /// A direction to go on in; its weight is that of a walk from the camera.
    #[inline]
    pub fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        let sample = self.model.sample(self.shading_normal, wo, u)?;
        (self.normal.dot(wo) > 0.0 && self.normal.dot(sample.wi) > 0.0).then_some(sample)
    }

    /// What the BRDF is multiplied with when a walk from `wo` goes on to `wi`.
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
            Walk::FromLight if planted(Defect::AdjointMissing) => self.shading_normal.dot(wi).abs(),
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

    /// Whether `wo` is on the front side, the only one that emits.
    pub fn is_front(&self) -> bool {
        self.normal == self.site.normal
    }
}
