//! The result of a job.

use crate::VERSION;
use crate::job::Job;
use crate::recipe;
use crate::window_options;
use std::collections::BTreeMap;
use std::time::Duration;
use traylib_integrators::{Method, Statistics};
use traylib_io::{Loaded, PictureInfo};
use traylib_math::{Grid, Rgb};

/// The result of a job.
#[derive(Debug)]
pub struct Done {
    /// The scene and its settings.
    pub loaded: Loaded,
    /// The number of passes.
    pub passes: u32,
    /// The picture's own estimate of its relative error.
    pub error: Option<f64>,
    /// Estimated variance of each pixel, if it was asked for and there is any.
    pub variance: Option<Grid<Rgb>>,
    /// Further pictures, by number.
    pub layers: BTreeMap<u16, Grid<Rgb>>,
    /// Text that was asked for.
    pub notes: Vec<String>,
    /// Counters of the work of this run.
    pub statistics: Statistics,
    /// Time that it took.
    pub elapsed: Duration,
    /// The work of the runs before; `None` if nothing is kept from run to run.
    pub before: Option<Before>,
}

/// The work of the runs that this one goes on from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Before {
    /// Passes.
    pub passes: u32,
    /// Samples that were left out.
    pub rejected: u64,
}

impl Done {
    /// Returns the description of this job for a picture.
    pub fn info(&self, job: &Job<'_>) -> PictureInfo {
        let before = self.before.unwrap_or_default();
        PictureInfo {
            exposure: self.loaded.settings.exposure,
            tone: job.options.tone,
            program: format!("TrayLib {VERSION}"),
            integrator: job.method.map_or(job.program, Method::name).into(),
            command: recipe::with_spp(&recipe::command(job, &self.loaded), self.passes),
            scene: self.loaded.name.clone(),
            seed: job.options.seed,
            spp: u64::from(self.passes),
            rejected_samples: self.statistics.rejected + before.rejected,
            frame: window_options::frame(self.loaded.scene.camera()),
        }
    }
}
