//! What a method does for a sample, counted.

use super::probes::Probes;
use crate::{BdptSettings, Method, PointSet, Statistics};

/// Means for one sample a pixel, with the light paths that belong to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Rays of walks from the camera into drawn directions.
    pub camera_bounces: f64,
    /// Shadow rays of camera paths.
    pub camera_shadows: f64,
    /// Light paths.
    pub light_paths: f64,
    /// Their rays.
    pub light_bounces: f64,
    /// Their shadow rays.
    pub light_shadows: f64,
}

/// Counts it over all probes, once.
pub(super) fn count_work(probes: &Probes<'_>, method: Method, points: PointSet) -> Work {
    let integrator = method.build();
    let count = probes.pixels.len() as f64;
    let light = probes.light_work(&*integrator, points);
    let mut all = Statistics::default();
    for statistics in probes.ask(&*integrator, points, 1, |_, _, probed| probed.statistics) {
        all += statistics;
    }
    // Light paths of a pass for each of its pixels, of which every probe had one.
    let ratio = match method {
        Method::Bdpt(BdptSettings { light_paths, .. }) => light_paths.ratio(),
        Method::Trace(_) | Method::PureMc(_) | Method::DirectLight(_) | Method::Particle(_) => 1.0,
    };
    let per_sample = |all: u64| all as f64 / count;
    Work {
        camera_bounces: per_sample(all.bounce_rays - light.bounce_rays),
        camera_shadows: per_sample(all.shadow_rays - light.shadow_rays),
        light_paths: ratio * per_sample(light.light_paths),
        light_bounces: ratio * per_sample(light.bounce_rays),
        light_shadows: ratio * per_sample(light.shadow_rays),
    }
}
