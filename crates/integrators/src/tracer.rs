//! The scene with a tally of what was asked of it.

use std::ops::AddAssign;
use traylib_geometry::Ray;
use traylib_scene::{Scene, SurfacePoint};

/// What a rendering did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Rays from the camera.
    pub camera_rays: u64,
    /// Rays from a lamp or a surface into a drawn direction.
    pub bounce_rays: u64,
    /// Questions whether two points see one another.
    pub shadow_rays: u64,
    /// Walks from the camera.
    pub camera_paths: u64,
    /// Walks from a lamp.
    pub light_paths: u64,
    /// Contributions left out because they were negative or not finite.
    pub rejected: u64,
}

impl Statistics {
    /// Rays of all kinds.
    pub fn rays(&self) -> u64 {
        self.camera_rays + self.bounce_rays + self.shadow_rays
    }
}

impl AddAssign for Statistics {
    fn add_assign(&mut self, other: Self) {
        self.camera_rays += other.camera_rays;
        self.bounce_rays += other.bounce_rays;
        self.shadow_rays += other.shadow_rays;
        self.camera_paths += other.camera_paths;
        self.light_paths += other.light_paths;
        self.rejected += other.rejected;
    }
}

/// A scene that counts the rays cast into it.
#[derive(Debug)]
pub(crate) struct Tracer<'scene> {
    pub(crate) scene: &'scene Scene,
    pub(crate) statistics: Statistics,
}

impl<'scene> Tracer<'scene> {
    pub(crate) fn new(scene: &'scene Scene) -> Self {
        Self { scene, statistics: Statistics::default() }
    }

    /// The first edge of a walk from the camera.
    pub(crate) fn camera_ray(&mut self, ray: &Ray) -> Option<SurfacePoint<'scene>> {
        self.statistics.camera_paths += 1;
        self.statistics.camera_rays += 1;
        self.scene.intersect(ray)
    }

    /// The first edge of a walk from a lamp.
    pub(crate) fn emission_ray(&mut self, ray: &Ray) -> Option<SurfacePoint<'scene>> {
        self.statistics.light_paths += 1;
        self.bounce_ray(ray)
    }

    /// Any later edge of a walk.
    pub(crate) fn bounce_ray(&mut self, ray: &Ray) -> Option<SurfacePoint<'scene>> {
        self.statistics.bounce_rays += 1;
        self.scene.intersect(ray)
    }

    /// Whether the camera sees a point. Asked from the camera, as all questions of
    /// the kind are from the side of the eye: through the back of a one-sided
    /// surface light passes that way only.
    pub(crate) fn seen_by_camera(&mut self, point: &SurfacePoint<'_>) -> bool {
        let pinhole = self.scene.camera().position();
        self.is_free(&point.site.segment_from_point(pinhole))
    }

    /// Whether nothing stands in the way of a segment.
    pub(crate) fn is_free(&mut self, segment: &Ray) -> bool {
        self.statistics.shadow_rays += 1;
        self.scene.is_free(segment)
    }
}
