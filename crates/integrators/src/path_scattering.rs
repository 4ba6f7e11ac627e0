//! BSDF and densities at a vertex of a path, whichever walk found it.

use crate::toward_light::TowardLight;
use traylib_materials::Scattering;
use traylib_math::{Rgb, SolidAnglePdf, Vec3};
use traylib_scene::{SurfacePoint, Walk};

/// BSDF and densities at a vertex, the densities named by the end of the path that they
/// lead to: a walk from the camera draws the one, a walk from a light the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathScattering {
    /// The BSDF, in 1/sr, without any cosine.
    pub f: Rgb,
    /// Density with which a walk from the camera goes on toward the light.
    pub toward_light: SolidAnglePdf,
    /// Density with which a walk from a light goes on toward the camera.
    pub toward_camera: SolidAnglePdf,
}

impl PathScattering {
    /// At a point that a walk reached from the unit direction `wo` and may leave in the unit
    /// direction `wi`, where walks from both ends go on by the surface alone.
    #[inline]
    pub(crate) fn by_surface(point: &SurfacePoint, walk: Walk, wo: Vec3, wi: Vec3) -> Self {
        let Scattering { f, pdf, pdf_reverse } = point.evaluate(wo, wi);
        match walk {
            Walk::FromCamera => Self { f, toward_light: pdf, toward_camera: pdf_reverse },
            Walk::FromLight => Self { f, toward_light: pdf_reverse, toward_camera: pdf },
        }
    }

    /// Takes account of how a walk from the camera goes on; `light_side` is the unit direction
    /// toward the light.
    #[inline]
    pub(crate) fn mix(
        &mut self,
        toward_light: TowardLight<'_>,
        point: &SurfacePoint,
        light_side: Vec3,
    ) {
        self.toward_light = toward_light.pdf(point, self.toward_light, light_side);
    }
}
