//! Joining a vertex of a light path to the camera (t = 1).

use crate::path_scattering::PathScattering;
use traylib_math::{Rgb, Vec3, solid_angle_per_area};
use traylib_scene::{Projection, Scene, SurfacePoint, Walk};

/// A way from a vertex to the camera that carries light, if nothing stands in
/// it.
#[derive(Clone, Copy, Debug)]
pub struct Splat {
    /// The vertex as the camera sees it.
    pub projection: Projection,
    /// The BSDF and densities at the vertex for the direction to the camera.
    pub scattering: PathScattering,
    /// The factor between the throughput of a light path, if it is the pass's only one, and the
    /// radiance of the pixel: f·cos·We.
    pub value: Rgb,
}

/// Aims at the camera from a vertex that a light path reached from `wo`. In
/// front of the camera, inside the picture, facing: the shadow ray comes last.
pub fn aim_at_camera(scene: &Scene, point: &SurfacePoint, wo: Vec3) -> Option<Splat> {
    if !point.model.has_smooth_part() {
        return None;
    }
    // Where on the film, if it is in view.
    let projection = scene.camera().project(point.site.position)?;
    // f toward the camera.
    let to_camera = projection.to_camera;
    let scattering = PathScattering::by_surface(point, Walk::FromLight, wo, to_camera);
    if scattering.f.is_black() {
        return None;
    }
    // The vertex's own cosine stands in the kernel; the camera's is in We.
    let cosine = point.cosine(Walk::FromLight, wo, to_camera);
    let value = scattering.f * (cosine * projection.pdf.0 / projection.distance_squared);
    Some(Splat { projection, scattering, value })
}

impl Splat {
    /// Row-major index of the pixel.
    pub fn pixel(&self, scene: &Scene) -> u32 {
        let Projection { x, y, .. } = self.projection;
        y * scene.camera().width() + x
    }

    /// Density with which a camera path would have found the vertex, per m².
    pub fn camera_pdf(&self, point: &SurfacePoint) -> f32 {
        let cosine = point.normal.dot(self.projection.to_camera).abs();
        let conversion = solid_angle_per_area(cosine, self.projection.distance_squared);
        self.projection.pdf.to_area(conversion).0
    }
}
