//! A few passes by all techniques, path by path.

use super::found::Found;
use super::probes::Probes;
use super::seen::LightsSeen;
use super::tiles::Tiles;
use crate::{Bdpt, BdptSettings, Limits, PointSet, Report};

/// Longer paths are left out of the pilot: they hold little light, and the number of ways to
/// find one grows with its length. Trials have them.
pub(super) const LONGEST: u32 = 16;

/// The paths that the pilot found, but for lamps that the camera sees.
pub(super) struct Pilot {
    /// Each path with the number of the probe that brought it and that of the pass, in the order
    /// of the probes.
    pub(super) found: Vec<Found>,
    /// Pixels of the probes that brought them.
    pub(super) pixels: Vec<u32>,
    /// Passes of each.
    pub(super) passes: u32,
    /// The tiles that errors are relative to.
    pub(super) tiles: Tiles,
}

impl Pilot {
    /// Asks the probes by independent points: what is told from them holds for each sample
    /// alone.
    pub(super) fn run(
        probes: &Probes<'_>,
        max_depth: Option<u32>,
        passes: u32,
        seen: &LightsSeen,
    ) -> Self {
        let longest = max_depth.map_or(LONGEST, |edges| edges.min(LONGEST));
        let limits = Limits { max_depth: Some(longest), ..Limits::NONE };
        let bdpt: Bdpt = BdptSettings { limits, ..BdptSettings::DEFAULT }.integrator(Report::Paths);
        let found = probes.ask(&bdpt, PointSet::Independent, passes, |probe, pass, probed| {
            let found = |path| Found { path, probe, pass };
            probed.paths.into_iter().map(found).collect::<Vec<_>>()
        });
        // Lights that the camera sees are no matter of choice.
        let found = found.into_iter().flatten().filter(|found| found.path.edges() > 1);
        let found: Vec<Found> = found.collect();
        let tiles = Tiles::of(probes, passes, &found, seen);
        Self { found, pixels: probes.pixels.clone(), passes, tiles }
    }

    /// Samples in all.
    pub(super) fn samples(&self) -> f64 {
        self.pixels.len() as f64 * f64::from(self.passes)
    }
}
