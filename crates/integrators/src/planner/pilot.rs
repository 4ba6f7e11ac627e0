//! A few passes by all techniques, path by path.

use super::probes::Probes;
use super::tiles::{Tiles, grey};
use crate::bdpt::{Bdpt, BdptSettings, FoundPath, Report};
use crate::{Limits, PointSet};
use traylib_math::Rgb;

/// Longer paths are left out of the pilot: they hold little light, and the number of ways to
/// find one grows with its length. Trials have them.
pub(super) const LONGEST: u32 = 16;

/// What the pilot found, but for lamps that the camera sees.
pub(super) struct Pilot {
    /// Each path with the number of the probe that brought it and that of the pass, in the order
    /// of the probes.
    pub(super) found: Vec<Found>,
    /// Pixels of the probes that brought them.
    pub(super) pixels: Vec<u32>,
    /// Passes of each.
    pub(super) passes: u32,
    /// What errors are relative to.
    pub(super) tiles: Tiles,
}

/// A path and who found it when.
pub(super) struct Found {
    pub(super) path: FoundPath,
    pub(super) probe: usize,
    pub(super) pass: u32,
}

impl Pilot {
    /// Independent points: what is told from them holds for each sample alone.
    pub(super) fn run(probes: &Probes<'_>, max_depth: Option<u32>, passes: u32) -> Self {
        let longest = max_depth.map_or(LONGEST, |edges| edges.min(LONGEST));
        let limits = Limits { max_depth: Some(longest), ..Limits::NONE };
        let bdpt: Bdpt = BdptSettings { limits, ..BdptSettings::DEFAULT }.integrator(Report::Paths);
        let found = probes.ask(&bdpt, PointSet::Independent, passes, |probe, pass, probed| {
            let found = |path| Found { path, probe, pass };
            probed.paths.into_iter().map(found).collect::<Vec<_>>()
        });
        // Lamps that the camera sees are the same to all methods, and far brighter than what
        // they light.
        let (seen, found): (Vec<Found>, Vec<Found>) =
            found.into_iter().flatten().partition(|found| found.path.edges() == 1);
        let seen = seen.iter().map(|found| grey(found.path.balanced())).sum();
        let tiles = Tiles::of(probes, passes, &found, seen);
        Self { found, pixels: probes.pixels.clone(), passes, tiles }
    }

    /// Samples in all.
    pub(super) fn samples(&self) -> f64 {
        self.pixels.len() as f64 * f64::from(self.passes)
    }
}

impl FoundPath {
    /// Its light by the balance heuristic over all techniques, of which each path is an
    /// unbiased sample.
    pub(super) fn balanced(&self) -> Rgb {
        self.value * (1.0 / self.ratios.iter().sum::<f64>()) as f32
    }

    /// The same over those that begin at the camera, if it was found by one of them: light of
    /// its own pixel.
    pub(super) fn own_light(&self) -> Option<Rgb> {
        (!self.is_splat).then(|| self.value * (1.0 / self.found_from_camera()) as f32)
    }

    /// How much more often techniques from the camera find it, all together, than the one that
    /// did.
    pub(super) fn found_from_camera(&self) -> f64 {
        // The last, t = 1, begins at no camera.
        self.ratios[..self.edges()].iter().sum()
    }
}
