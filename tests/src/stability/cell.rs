//! A method over a scene: sixteen runs, and what is kept of their passes.

use crate::stability::reference::{Reference, values};
use traylib_integrators::Method;
use traylib_known::{each_pass, settings_by_pass};
use traylib_scene::Scene;
use traylib_statistics::tail::Largest;
use traylib_statistics::{Energy, PowerSums};

/// Independent runs of each cell.
pub const RUNS: u64 = 16;

/// The sum of one run's passes, each time their number is a power of two.
pub type Sums = Vec<Vec<f64>>;

/// The data that is kept of a cell's passes. Values are means of the bands.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    /// Passes in each run, a power of two.
    pub passes: u32,
    /// One a run.
    pub runs: Vec<Sums>,
    /// Largest values of single passes, of all pixels together: each over what
    /// its pixel's error is divided by for relMSE, so that a bright pixel is no
    /// tail.
    pub largest: Largest,
    /// Power sums of these, of the first half of each run.
    pub half: PowerSums,
    /// The sums of all.
    pub all: PowerSums,
    /// The distribution of their energy.
    pub energy: Energy,
    /// Sum of squares over all runs, one a pixel.
    pub squares: Vec<f64>,
    /// Samples that were not sound numbers.
    pub rejected: u64,
    /// The time of one pass, where somebody timed it ([`cost`](traylib_known::cost)).
    pub seconds: f64,
}

/// Renders a cell.
pub fn run(
    scene: &Scene,
    reference: &Reference,
    method: Method,
    max_depth: Option<u32>,
    passes: u32,
) -> Kept {
    let units: Vec<f64> = reference.scales().into_iter().map(f64::sqrt).collect();
    let integrator = method.up_to(max_depth).build();
    let mut kept = Kept { passes, ..Kept::default() };
    for seed in 1..=RUNS {
        let settings = settings_by_pass(passes, seed);
        let mut run = Run::default();
        let statistics = each_pass(scene, integrator.as_ref(), &settings, |pass| {
            let pass: Vec<f64> = values(&pass).collect();
            run.add(&pass);
            kept.add(&pass, &units, run.passes);
        });
        kept.rejected += statistics.rejected;
        kept.runs.push(run.checkpoints);
    }
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
    fn add(&mut self, pass: &[f64], units: &[f64], number: u32) {
        self.squares.resize(pass.len(), 0.0);
        for ((square, &value), unit) in self.squares.iter_mut().zip(pass).zip(units) {
            *square += value * value;
            let value = value / unit;
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
        let n = f64::from(1_u32 << level);
        self.runs[run][level].iter().map(|sum| sum / n).collect()
    }

    /// Variance of one pixel over all single passes, free of what rounding leaves
    /// of none.
    pub fn variance(&self, pixel: usize) -> f64 {
        let n = f64::from(self.passes) * self.runs.len() as f64;
        let sum: f64 = self.runs.iter().map(|run| run[self.last_level()][pixel]).sum();
        let (mean, square) = (sum / n, self.squares[pixel] / n);
        let variance = square - mean * mean;
        if variance > 1e-12 * square { variance } else { 0.0 }
    }

    /// The number of the last level: 2 to it are all passes.
    pub fn last_level(&self) -> usize {
        self.passes.ilog2() as usize
    }
}
