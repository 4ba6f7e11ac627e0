//! One run: a method renders until its time is up, and is looked at on the way.

use crate::memory::peak_during;
use crate::picture::{Picture, grey};
use crate::reference::Reference;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
use traylib_integrators::planner::{Request, plan};
use traylib_integrators::{
    Control, Method, PointSet, Progress, Rendering, Settings, Statistics, ThreadError, render,
};
use traylib_scene::Scene;
use traylib_statistics::PictureError;
use traylib_statistics::tail::Largest;

/// The record of a run, which is kept beside its picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Passes rendered.
    pub passes: u32,
    /// Seconds that they took.
    pub seconds: f64,
    /// Snapshots of it on the way, by time; the last is at its end.
    pub snapshots: Vec<Snapshot>,
    /// relMSE without the worst 0.1 % of pixels, at the end.
    pub trimmed_rel_mse: f64,
    /// SMAPE at the end.
    pub smape: f64,
    /// Mean of the picture over that of the reference.
    pub mean_ratio: f64,
    /// Rays from the camera, from surfaces and lamps, and between points.
    pub rays: [u64; 3],
    /// The method that a plan chose for it, if one was made.
    pub plan: Option<String>,
    /// Samples that were left out.
    pub rejected: u64,
    /// Most bytes held on the way, beside scene and reference.
    pub peak_bytes: u64,
    /// The largest values of single passes, over what errors are divided by.
    pub largest: Vec<f64>,
}

/// The error at some time; the reference's own noise is in it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Passes so far.
    pub passes: u32,
    /// Seconds so far.
    pub seconds: f64,
    /// relMSE.
    pub error: f64,
    /// The index of the budget that had just been used up, if one had.
    pub budget: Option<usize>,
}

/// The settings that all runs on a scene have in common.
#[derive(Clone, Copy, Debug)]
pub struct Race<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The reference that pictures are held against.
    pub reference: &'a Reference,
    /// In seconds, ascending; not empty.
    pub budgets: &'a [f64],
    /// Threads; 0 for one a processor.
    pub threads: usize,
    /// The source of random numbers.
    pub points: PointSet,
    /// Raised when the user wants to stop.
    pub stop: &'a Control,
}

impl Race<'_> {
    /// Renders until the longest budget is used up: the record and the picture;
    /// `None` if it was stopped.
    ///
    /// # Errors
    /// The system refuses threads.
    pub fn run(&self, method: Method, seed: u64) -> Result<Option<(Record, Picture)>, ThreadError> {
        let settings = Settings { spp: u32::MAX, seed, threads: self.threads, points: self.points };
        let mut watch = Watch::new(self);
        // The time of a plan counts.
        let Some(planned) = self.planned(method, seed)? else { return Ok(None) };
        watch.plan = (planned != method).then(|| planned.to_string());
        let integrator = planned.build();
        let (rendering, peak_bytes) = peak_during(|| {
            render(self.scene, integrator.as_ref(), &settings, self.stop, &mut |p| {
                watch.after_pass(p)
            })
        });
        let rendering = rendering?;
        let finished = watch.has_finished();
        Ok(finished.then(|| (watch.record(&rendering, peak_bytes), rendering.film.mean())))
    }

    /// Returns the method to render by: another, if `method` leaves that to a plan; `None` if it
    /// was stopped.
    fn planned(&self, method: Method, seed: u64) -> Result<Option<Method>, ThreadError> {
        let settings =
            Settings { spp: PLANNED_SPP, seed, threads: self.threads, points: self.points };
        let Some(request) = Request::of(method, &settings) else { return Ok(Some(method)) };
        Ok(plan(self.scene, &request, self.stop)?.map(|plan| plan.method))
    }

    /// Renders for about this long and keeps nothing: caches, clock rates and
    /// threads are then as they will be.
    ///
    /// # Errors
    /// The system refuses threads.
    pub fn warm_up(&self, method: Method, time: Duration) -> Result<(), ThreadError> {
        let start = Instant::now();
        let settings =
            Settings { spp: u32::MAX, seed: 0, threads: self.threads, points: self.points };
        let integrator = method.build();
        render(self.scene, integrator.as_ref(), &settings, self.stop, &mut |_| {
            if start.elapsed() >= time { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })?;
        Ok(())
    }
}

/// Samples a pixel that a plan thinks there will be. Nobody knows before the time is up: as many
/// as programs take of scenes that do not say.
const PLANNED_SPP: u32 = 64;

/// Takes snapshots after each pass, with the clock stopped.
struct Watch<'a> {
    race: &'a Race<'a>,
    /// The divisors of pass values: roots of r² + ε, of the mean of the bands.
    units: Vec<f64>,
    before: Vec<f64>,
    largest: Largest,
    snapshots: Vec<Snapshot>,
    next_budget: usize,
    plan: Option<String>,
    gone: Duration,
    since: Instant,
}

impl<'a> Watch<'a> {
    fn new(race: &'a Race<'a>) -> Self {
        let reference = race.reference;
        let unit = |bands: &[f64; 3]| (grey(bands).powi(2) + reference.epsilon).sqrt();
        Self {
            race,
            units: reference.picture.values().iter().map(unit).collect(),
            before: vec![0.0; reference.picture.values().len()],
            largest: Largest::default(),
            snapshots: Vec::new(),
            next_budget: 0,
            plan: None,
            gone: Duration::ZERO,
            since: Instant::now(),
        }
    }

    fn after_pass(&mut self, progress: &Progress<'_>) -> ControlFlow<()> {
        self.gone += self.since.elapsed();
        let passes = progress.film.passes();
        let mean = progress.film.mean();
        self.add_tail(&mean, passes);
        let seconds = self.gone.as_secs_f64();
        let budgets = self.race.budgets;
        let used = budgets[self.next_budget..].iter().take_while(|b| seconds >= **b).count();
        self.next_budget += used;
        let budget = (used > 0).then(|| self.next_budget - 1);
        if budget.is_some() || passes.is_power_of_two() {
            let error = self.race.reference.rel_mse(&mean);
            self.snapshots.push(Snapshot { passes, seconds, error, budget });
        }
        if self.has_finished() {
            return ControlFlow::Break(());
        }
        self.since = Instant::now();
        ControlFlow::Continue(())
    }

    /// Tells whether all budgets are used up; not if the run was stopped before.
    fn has_finished(&self) -> bool {
        self.next_budget == self.race.budgets.len()
    }

    /// The pass itself is the growth of the sum.
    fn add_tail(&mut self, mean: &Picture, passes: u32) {
        for ((bands, before), unit) in mean.values().iter().zip(&mut self.before).zip(&self.units) {
            let sum = grey(bands) * f64::from(passes);
            self.largest.add((sum - *before) / unit);
            *before = sum;
        }
    }

    fn record(self, rendering: &Rendering, peak_bytes: u64) -> Record {
        let picture = rendering.film.mean();
        let reference = self.race.reference;
        let error =
            PictureError::between(picture.values(), reference.picture.values(), reference.epsilon);
        let Statistics { camera_rays, bounce_rays, shadow_rays, rejected, .. } =
            rendering.statistics;
        Record {
            passes: rendering.film.passes(),
            seconds: self.gone.as_secs_f64(),
            snapshots: self.snapshots,
            trimmed_rel_mse: error.map_or(0.0, |e| e.trimmed_rel_mse),
            smape: error.map_or(0.0, |e| e.smape),
            mean_ratio: error.map_or(0.0, |e| e.mean_ratio),
            rays: [camera_rays, bounce_rays, shadow_rays],
            plan: self.plan,
            rejected,
            peak_bytes,
            largest: self.largest.descending(),
        }
    }
}
