//! The scene with counters of what was asked of it.

use crate::Control;
use std::ops::AddAssign;
use traylib_geometry::Ray;
use traylib_math::Rgb;
use traylib_scene::{MAX_PASS_THROUGHS, Scene, SurfacePoint, Walk};

/// Counts of the rays, paths and rejected samples of a rendering.
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
pub struct Tracer<'scene> {
    /// The scene itself, for questions that are no rays.
    pub scene: &'scene Scene,
    /// The counts so far. A chunk adds it to its [`ChunkOutput`](crate::ChunkOutput).
    pub statistics: Statistics,
    control: &'scene Control,
}

impl<'scene> Tracer<'scene> {
    /// A tracer that has asked nothing. Once `control` is cancelled it finds nothing
    /// either.
    pub fn new(scene: &'scene Scene, control: &'scene Control) -> Self {
        Self { scene, statistics: Statistics::default(), control }
    }

    /// Tells whether nobody wants the answers any more: no ray meets anything then, and no
    /// point sees another, so that walks end.
    pub fn is_cancelled(&self) -> bool {
        self.control.is_cancelled()
    }

    /// The first edge of a walk from the camera; `pass_through` as for
    /// [`bounce_ray`](Self::bounce_ray). What meets no surface meets the sky, if there is one:
    /// see [`Scene::sky_behind`].
    #[inline]
    pub fn camera_ray(&mut self, ray: &Ray, pass_through: f32) -> Option<SurfaceHit> {
        self.edge_from_camera(1, ray, pass_through)
    }

    /// The edge with number `edge` of a walk from the camera, counted from 1; it may end at the
    /// sky as the [first](Self::camera_ray) does.
    #[inline]
    pub fn edge_from_camera(
        &mut self,
        edge: u32,
        ray: &Ray,
        pass_through: f32,
    ) -> Option<SurfaceHit> {
        let is_first = edge == 1;
        self.statistics.camera_paths += u64::from(is_first);
        self.meet(ray, pass_through, is_first, true)
    }

    /// Finds the first surface on each of some rays from the camera, be it see-through or not; of
    /// no ray once it is cancelled.
    pub fn intersect_each<'a>(
        &mut self,
        rays: &'a [Ray],
    ) -> impl Iterator<Item = Option<SurfacePoint>> + use<'a, 'scene>
    where
        'scene: 'a,
    {
        let rays = if self.is_cancelled() { &[] } else { rays };
        self.statistics.camera_rays += rays.len() as u64;
        self.scene.intersect_each(rays)
    }

    /// [`sees`](Self::sees) for each segment of a list; black where nothing comes through.
    pub fn sees_each(&mut self, segments: &[Ray]) -> Vec<Rgb> {
        if self.is_cancelled() {
            return vec![Rgb::BLACK; segments.len()];
        }
        self.statistics.shadow_rays += segments.len() as u64;
        self.scene.transmittance_each(segments)
    }

    /// Any edge of a walk from a lamp, and of one from the camera where the sky does not count.
    /// The number `pass_through` decides where it ends if light can pass straight through
    /// surfaces on its way.
    #[inline]
    pub fn bounce_ray(&mut self, ray: &Ray, pass_through: f32) -> Option<SurfaceHit> {
        self.meet(ray, pass_through, false, false)
    }

    /// Any later edge of a walk from either end: one from the camera may end at the sky.
    #[inline]
    pub(crate) fn later_edge(
        &mut self,
        walk: Walk,
        ray: &Ray,
        pass_through: f32,
    ) -> Option<SurfaceHit> {
        self.meet(ray, pass_through, false, walk == Walk::FromCamera)
    }

    /// The surface that a walk goes on from, or what is behind all surfaces. What lets light
    /// straight through is passed with the chance of the band that it weakens least. A
    /// pass-through is no vertex: its chance scales the estimator alone, as roulette does,
    /// and is in no density and no weight.
    #[expect(
        clippy::inline_always,
        reason = "its result is large: in place it is not written to memory"
    )]
    #[inline(always)]
    fn meet(
        &mut self,
        ray: &Ray,
        mut pass_through: f32,
        is_from_camera: bool,
        sees_sky: bool,
    ) -> Option<SurfaceHit> {
        if self.is_cancelled() {
            return None;
        }
        let Statistics { camera_rays, bounce_rays, .. } = &mut self.statistics;
        let rays = if is_from_camera { camera_rays } else { bounce_rays };
        // From surface to surface, for as long as chance says straight on.
        let (mut transmittance, mut rest) = (Rgb::WHITE, *ray);
        for _ in 0..MAX_PASS_THROUGHS {
            *rays += 1;
            // In the place from where it is returned: a point is large.
            let met = self.scene.intersect(&rest);
            let mut hit = met.map(|point| SurfaceHit { point, transmittance });
            let Some(SurfaceHit { point, transmittance: passed }) = hit.as_mut() else {
                let sees_sky = sees_sky && self.scene.sky().is_some();
                return if sees_sky { meet_sky(self.scene, &rest, transmittance) } else { None };
            };
            // One number decides for all: what is left of it is uniform again.
            let chance = point.through.max_band();
            if pass_through >= chance {
                *passed *= point.opacity / (1.0 - chance);
                return hit;
            }
            transmittance = transmittance * point.through / chance;
            pass_through /= chance;
            rest.origin = point.site.ray_origin(rest.direction);
        }
        None
    }

    /// Returns the part of the light of a point that the camera sees. Asked from the camera,
    /// as all questions of the kind are from the side of the eye: through the
    /// back of a one-sided surface light passes that way only.
    pub fn seen_by_camera(&mut self, point: &SurfacePoint) -> Option<Rgb> {
        // The pinhole is in free space: only the surface's end is lifted.
        let pinhole = self.scene.camera().position();
        self.sees(&point.site.segment_from_point(pinhole))
    }

    /// The part of the light that a segment lets through, if any.
    pub fn sees(&mut self, segment: &Ray) -> Option<Rgb> {
        if self.is_cancelled() {
            return None;
        }
        // One shadow ray, however many panes are in its way.
        self.statistics.shadow_rays += 1;
        Some(self.scene.transmittance(segment)).filter(|part| !part.is_black())
    }
}

/// Returns the point of the sky at which an edge of a walk from the camera ends that meets no
/// surface.
#[inline(never)]
fn meet_sky(scene: &Scene, ray: &Ray, transmittance: Rgb) -> Option<SurfaceHit> {
    scene.sky_behind(ray).map(|point| SurfaceHit { point, transmittance })
}

/// The end of an edge of a walk.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit {
    /// The surface, seen from the side that the ray came from.
    pub point: SurfacePoint,
    /// The transmittance of the surfaces that the edge passed, a factor of the throughput.
    pub transmittance: Rgb,
}
