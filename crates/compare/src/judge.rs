//! From runs to what is told of them.

mod curve;
mod steadiness;
mod trust;
mod verdict;

pub use trust::{doubted_by, withhold};
pub use verdict::{no_verdict, verdict};

use crate::bootstrap;
use crate::method::{blind_spots, is_biased, longest_path};
use crate::picture::Picture;
use crate::reference::Reference;
use crate::results::{Estimate, MethodResults, Metrics, Rays, Target};
use crate::run::Record;
use curve::{averaged, budgets, powers_of_two};
use steadiness::steadiness;
use traylib_integrators::{Method, SceneFacts};
use traylib_math::Grid;
use traylib_statistics::{Sample, quantile, relative_square_errors};

/// The errors whose price is asked.
pub const TARGETS: [f64; 3] = [1e-1, 1e-2, 1e-3];

/// The level of every interval but those that hold together.
const LEVEL: f64 = 0.05;

/// A method and its runs.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The method.
    pub method: Method,
    /// The record of each run.
    pub records: Vec<Record>,
    /// Its picture at the end of each.
    pub pictures: Vec<Picture>,
}

impl Entry {
    /// relMSE at the end of each run, the reference's own taken off.
    fn errors(&self, reference: &Reference) -> Vec<f64> {
        self.records.iter().map(|record| reference.less_own(record.last_error())).collect()
    }

    /// Error times seconds of each run.
    fn costs(&self, reference: &Reference) -> Vec<f64> {
        let errors = self.errors(reference);
        errors.iter().zip(&self.records).map(|(error, record)| error * record.seconds).collect()
    }

    /// (x − r)²/(r² + ε) of each pixel, mean of all runs.
    pub fn error_map(&self, reference: &Reference) -> Grid<f64> {
        let mut sum = reference.picture.map(|_| 0.0);
        let share = 1.0 / self.pictures.len().max(1) as f64;
        for picture in &self.pictures {
            let [x, r] = [picture.values(), reference.picture.values()];
            let errors = relative_square_errors(x, r, reference.epsilon);
            for (sum, error) in sum.values_mut().iter_mut().zip(errors.iter().flatten()) {
                *sum += share * error;
            }
        }
        sum
    }
}

impl Record {
    fn last_error(&self) -> f64 {
        self.snapshots.last().map_or(f64::NAN, |snapshot| snapshot.error)
    }
}

/// Judges all entries of a scene against one another; each has at least two runs.
pub fn judge(entries: &[Entry], reference: &Reference, facts: SceneFacts) -> Vec<MethodResults> {
    let alone: Vec<MethodResults> =
        entries.iter().map(|entry| method(entry, reference, facts)).collect();
    let Some(best) = best(&alone) else { return alone };
    let level = LEVEL / entries.len().saturating_sub(1).max(1) as f64;
    let costs_of_best = entries[best].costs(reference);
    let mut judged = alone;
    let of_best_unknown = judged[best].stability.alarm;
    for (index, (method, entry)) in judged.iter_mut().zip(entries).enumerate() {
        if index != best {
            let ratio = bootstrap::ratio(&entry.costs(reference), &costs_of_best, level);
            let ratio = if of_best_unknown { ratio.without_low() } else { ratio };
            method.cost_ratio = if method.stability.alarm { ratio.without_high() } else { ratio };
        }
    }
    judged
}

/// Takes away what no runs can tell of values without a variance: how large their mean
/// may be.
fn without_high_ends(mut method: MethodResults) -> MethodResults {
    let points = method.points.iter_mut().chain(&mut method.budgets).map(|point| &mut point.error);
    let times = method.targets.iter_mut().filter_map(|target| target.seconds.as_mut());
    let others = [&mut method.cost, &mut method.error_per_pass];
    points.chain(times).chain(others).for_each(|estimate| *estimate = estimate.without_high());
    method
}

/// The cheapest that loses no light and has a variance, if there is one.
fn best(methods: &[MethodResults]) -> Option<usize> {
    let cheapest = |fit: &dyn Fn(&MethodResults) -> bool| {
        let costs = methods.iter().enumerate().filter(|(_, method)| fit(method));
        costs.min_by(|a, b| a.1.cost.value.total_cmp(&b.1.cost.value)).map(|(index, _)| index)
    };
    cheapest(&|method| !method.biased && !method.stability.alarm)
        .or_else(|| cheapest(&|method| !method.biased))
        .or_else(|| cheapest(&|_| true))
}

fn method(entry: &Entry, reference: &Reference, facts: SceneFacts) -> MethodResults {
    let biased = is_biased(entry.method, &facts);
    let spread = Spread::of(entry, reference);
    let lost = if biased { spread.lost } else { 0.0 };
    let mut points = budgets(entry, reference);
    points.extend(averaged(entry, reference));
    let method = MethodResults {
        name: entry.method.to_string(),
        biased,
        blind: blind_spots(entry.method, &facts),
        longest_path: longest_path(entry.method),
        points: powers_of_two(entry, reference),
        budgets: points,
        cost: bootstrap::mean(&entry.costs(reference), LEVEL),
        cost_ratio: Estimate { value: 1.0, low: 1.0, high: 1.0 },
        error_per_pass: noise_times(entry, reference, lost, |run| f64::from(run.passes)),
        seconds_per_pass: seconds_per_pass(entry),
        targets: targets(entry, reference, lost),
        metrics: metrics(entry, reference, &spread),
        rays: rays(entry),
        peak_bytes: entry.records.iter().map(|record| record.peak_bytes).max().unwrap_or(0),
        stability: steadiness(entry, reference),
        plans: plans(entry),
    };
    if method.stability.alarm { without_high_ends(method) } else { method }
}

/// Returns the choices that plans made for the runs, each once.
fn plans(entry: &Entry) -> Vec<String> {
    let mut plans: Vec<String> =
        entry.records.iter().filter_map(|record| record.plan.clone()).collect();
    plans.sort();
    plans.dedup();
    plans
}

/// The parts of the error: of R runs, one has the error lost + noise, their mean lost + noise/R.
struct Spread {
    /// Mean relMSE of a run, less the reference's.
    error: f64,
    /// Variance between runs.
    noise: f64,
    /// The part that no number of runs takes away.
    lost: f64,
}

impl Spread {
    fn of(entry: &Entry, reference: &Reference) -> Self {
        let runs = entry.records.len() as f64;
        let single = Sample::of(&raw_errors(entry)).mean;
        let mean = curve::mean_picture(&entry.records, &entry.pictures);
        let of_mean = mean.map_or(single, |mean| reference.rel_mse(&mean));
        let noise = (single - of_mean) * runs / (runs - 1.0);
        let error = single - reference.results.own_error;
        Self { error, noise, lost: (error - noise).max(0.0) }
    }
}

fn raw_errors(entry: &Entry) -> Vec<f64> {
    entry.records.iter().map(Record::last_error).collect()
}

/// The noise of a run times what it falls with, passes or seconds: mean over the runs.
/// Where hardly any noise is left beside the lost part, a hundredth of the error stands for it.
fn noise_times(
    entry: &Entry,
    reference: &Reference,
    lost: f64,
    effort: impl Fn(&Record) -> f64,
) -> Estimate {
    let errors = entry.errors(reference);
    let noise = |error: f64| (error - lost).max(0.01 * error);
    let runs = errors.into_iter().zip(&entry.records);
    let values: Vec<f64> = runs.map(|(error, record)| noise(error) * effort(record)).collect();
    bootstrap::mean(&values, LEVEL)
}

fn seconds_per_pass(entry: &Entry) -> Estimate {
    let each: Vec<f64> =
        entry.records.iter().map(|r| r.seconds / f64::from(r.passes.max(1))).collect();
    Estimate { value: quantile(&each, 0.5), low: quantile(&each, 0.0), high: quantile(&each, 1.0) }
}

/// Times to the errors of [`TARGETS`]: noise falls as one over time. Nothing is
/// faster than a pass.
fn targets(entry: &Entry, reference: &Reference, lost: f64) -> Vec<Target> {
    let cost = noise_times(entry, reference, lost, |run| run.seconds);
    let shortest = seconds_per_pass(entry).value;
    let time = |error: f64| cost.map(|cost| (cost / (error - lost)).max(shortest));
    TARGETS.map(|error| Target { error, seconds: (error > lost).then(|| time(error)) }).to_vec()
}

fn metrics(entry: &Entry, reference: &Reference, spread: &Spread) -> Metrics {
    let mean =
        |f: &dyn Fn(&Record) -> f64| Sample::of(&entry.records.iter().map(f).collect::<Vec<f64>>());
    let ratio = mean(&|record| record.mean_ratio);
    let variance = ratio.variance_of_mean + reference.relative_variance_of_mean();
    let bias = ratio.mean - 1.0;
    Metrics {
        rel_mse: spread.error,
        trimmed_rel_mse: mean(&|record| record.trimmed_rel_mse).mean,
        smape: mean(&|record| record.smape).mean,
        bias,
        bias_z: if variance > 0.0 { bias / variance.sqrt() } else { 0.0 },
        noise_share: if spread.error > 0.0 { spread.noise / spread.error } else { 1.0 },
    }
}

fn rays(entry: &Entry) -> Rays {
    let total = |f: &dyn Fn(&Record) -> f64| entry.records.iter().map(f).sum::<f64>();
    let passes = total(&|record| f64::from(record.passes)).max(1.0);
    let [camera, bounce, shadow] =
        [0, 1, 2].map(|kind| total(&|record| record.rays[kind] as f64) / passes);
    let seconds = total(&|record| record.seconds);
    Rays { camera, bounce, shadow, per_second: (camera + bounce + shadow) * passes / seconds }
}

#[cfg(test)]
mod tests;
