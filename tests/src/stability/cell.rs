//! A program over a scene: sixteen runs, and what is kept of their passes.

use crate::measure::each_pass;
use crate::stability::column::Column;
use crate::stability::moments::{Energy, Moments};
use crate::stability::reference::values;
use crate::stability::tail::Largest;
use std::ops::ControlFlow;
use std::time::Instant;
use traylib_integrators::{Settings, render};
use traylib_scene::Scene;

/// Independent runs of each cell.
pub const RUNS: u64 = 16;

/// The sum of one run's passes, each time their number is a power of two.
pub type Sums = Vec<Vec<f64>>;

/// All that is kept of a cell's passes. Values are means of the bands.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    /// Passes in each run, a power of two.
    pub passes: u32,
    /// One a run.
    pub runs: Vec<Sums>,
    /// Largest values of single passes, of all pixels together.
    pub largest: Largest,
    /// Their power sums, of the first half of each run.
    pub half: Moments,
    /// Of all.
    pub all: Moments,
    /// How their energy is spread.
    pub energy: Energy,
    /// Sum of squares over all runs, one a pixel.
    pub squares: Vec<f64>,
    /// Samples that were not sound numbers.
    pub rejected: u64,
    /// Of one pass: the shortest of a few short runs, in which nothing is kept.
    pub seconds: f64,
}

/// Renders a cell.
pub fn run(scene: &Scene, column: Column, max_depth: Option<u32>, passes: u32) -> Kept {
    let integrator = column.integrator(max_depth);
    let mut kept = Kept { passes, ..Kept::default() };
    for seed in 1..=RUNS {
        let settings = Settings { spp: passes, seed, threads: 1 };
        let mut run = Run::default();
        let statistics = each_pass(scene, integrator.as_ref(), &settings, |pass| {
            let pass: Vec<f64> = values(&pass).collect();
            run.add(&pass);
            kept.add(&pass, run.passes);
        });
        kept.rejected += statistics.rejected;
        kept.runs.push(run.checkpoints);
    }
    kept.seconds = seconds_per_pass(scene, column, max_depth);
    kept
}

/// One run so far.
#[derive(Default)]
struct Run {
    passes: u32,
    sum: Vec<f64>,
    checkpoints: Sums,
}

impl Run {
    fn add(&mut self, pass: &[f64]) {
        self.sum.resize(pass.len(), 0.0);
        for (sum, value) in self.sum.iter_mut().zip(pass) {
            *sum += value;
        }
        self.passes += 1;
        if self.passes.is_power_of_two() {
            self.checkpoints.push(self.sum.clone());
        }
    }
}

impl Kept {
    fn add(&mut self, pass: &[f64], number: u32) {
        self.squares.resize(pass.len(), 0.0);
        for (square, &value) in self.squares.iter_mut().zip(pass) {
            *square += value * value;
            self.largest.add(value);
            self.all.add(value);
            self.energy.add(value);
            if number <= self.passes / 2 {
                self.half.add(value);
            }
        }
    }

    /// The mean of each pixel in one run after 2^`level` passes.
    pub fn picture(&self, run: usize, level: usize) -> Vec<f64> {
        let n = 2.0_f64.powi(level as i32);
        self.runs[run][level].iter().map(|sum| sum / n).collect()
    }

    /// The number of the last level: 2 to it are all passes.
    pub fn last_level(&self) -> usize {
        self.passes.ilog2() as usize
    }
}

fn seconds_per_pass(scene: &Scene, column: Column, max_depth: Option<u32>) -> f64 {
    const PASSES: u32 = 24;
    let integrator = column.integrator(max_depth);
    let once = |seed| {
        let settings = Settings { spp: PASSES, seed, threads: 1 };
        let mut first = None;
        // The first pass is left out: it warms caches and starts the thread.
        let rendering = render(scene, integrator.as_ref(), &settings, &mut |_| {
            first.get_or_insert_with(Instant::now);
            ControlFlow::Continue(())
        });
        rendering.expect("one thread");
        first.map_or(0.0, |first| first.elapsed().as_secs_f64()) / f64::from(PASSES - 1)
    };
    (0..5).map(once).fold(f64::INFINITY, f64::min)
}
