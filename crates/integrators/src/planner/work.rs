//! The counted work of a method for a sample.

use super::probes::Probes;
use crate::{Method, MethodSetting, PathsPerPixel, PointSet, Statistics};
use traylib_math::Heuristic;

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

impl Work {
    /// With so many light paths for each that there was.
    fn with_light_paths(self, ratio: f64) -> Self {
        Self {
            light_paths: ratio * self.light_paths,
            light_bounces: ratio * self.light_bounces,
            light_shadows: ratio * self.light_shadows,
            ..self
        }
    }
}

/// The work counted so far, shared by methods that differ only in weights or in how many light
/// paths they have: both leave the work of each path as it is, but for a few connections.
#[derive(Default)]
pub(super) struct Counted(Vec<(Method, Work)>);

impl Counted {
    /// The work of a method over all probes, once.
    pub(super) fn of(&mut self, probes: &Probes<'_>, method: Method, points: PointSet) -> Work {
        let plain = without_weights(method);
        let found = self.0.iter().find(|(other, _)| *other == plain).map(|(_, work)| *work);
        let work = found.unwrap_or_else(|| {
            let work = count(probes, plain, points);
            self.0.push((plain, work));
            work
        });
        work.with_light_paths(method.light_paths_per_pixel())
    }

    /// Returns the number of methods counted.
    pub(super) fn methods(&self) -> usize {
        self.0.len()
    }
}

/// The method with one light path a pixel and the usual weights.
fn without_weights(method: Method) -> Method {
    let usual =
        [MethodSetting::Heuristic(Heuristic::Power), MethodSetting::LightPaths(PathsPerPixel::ONE)];
    usual.into_iter().fold(method, |method, setting| method.and(setting).unwrap_or(method))
}

fn count(probes: &Probes<'_>, method: Method, points: PointSet) -> Work {
    let integrator = method.build();
    let light = probes.light_work(&*integrator, points);
    let mut all = Statistics::default();
    for statistics in probes.ask(&*integrator, points, 1, |_, _, probed| probed.statistics) {
        all += statistics;
    }
    let per_sample = |all: u64| all as f64 / probes.pixels.len() as f64;
    Work {
        camera_bounces: per_sample(all.bounce_rays - light.bounce_rays),
        camera_shadows: per_sample(all.shadow_rays - light.shadow_rays),
        light_paths: per_sample(light.light_paths),
        light_bounces: per_sample(light.bounce_rays),
        light_shadows: per_sample(light.shadow_rays),
    }
}
