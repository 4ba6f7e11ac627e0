//! Techniques one by one: every way to find a path must find the same light.
//!
//! A batch is a rendering with a seed of its own; batches are independent.

use crate::findings::Finding;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use traylib_integrators::{
    Bdpt, Control, Limits, Progress, Report, Roulette, Technique, TechniqueSet, Weighting, render,
};
use traylib_known::furnace::{glowing_ball, offset_light_wide};
use traylib_known::sky::translucent_ball;
use traylib_known::{Case, samples_in_a_pass, settings_by_pass};
use traylib_materials::SurfaceModel;
use traylib_math::{Heuristic, Sampler};
use traylib_statistics::{Interval, mean_interval};

/// A technique: vertices from the light, vertices from the camera.
pub type Pair = (usize, usize);

/// A scene whose mean radiance over the film is known for each length of path.
#[derive(Debug)]
pub struct Spectrum {
    /// The scene, its paths at most as long as the last length.
    pub case: Case,
    /// The mean radiance that paths of k edges bring, by k; from two edges on.
    pub by_length: BTreeMap<usize, f64>,
    /// Techniques that exist in the scene, without the lamp seen directly.
    pub techniques: Vec<Pair>,
}

const LONGEST: u32 = 5;

/// A ball that glows: k edges bring Le·ρ^(k−1), by any technique.
pub fn ball(walls: SurfaceModel) -> Spectrum {
    let case = glowing_ball(walls, Some(LONGEST));
    let by_length = (2..=LONGEST).map(|k| (k as usize, 0.5_f64.powf(f64::from(k - 1)))).collect();
    Spectrum { case, by_length, techniques: pairs(0) }
}

/// A point light in a ball, off its centre; no path hits it.
pub fn lit_ball() -> Spectrum {
    let up_to = |k| offset_light_wide(Some(k)).truth;
    let by_length = (2..=LONGEST)
        .map(|k| (k as usize, up_to(k) - if k > 2 { up_to(k - 1) } else { 0.0 }))
        .collect();
    Spectrum { case: offset_light_wide(Some(LONGEST)), by_length, techniques: pairs(1) }
}

/// The inside of a ball that passes half of the light of a sky of 1: k edges bring half of ρ^(k−1),
/// by any technique.
pub fn open_ball() -> Spectrum {
    let case = translucent_ball(Some(LONGEST));
    let by_length = (2..=LONGEST).map(|k| (k as usize, 0.5_f64.powf(f64::from(k)))).collect();
    Spectrum { case, by_length, techniques: pairs(0) }
}

/// All (s, t) from the s given, for paths of two edges or more.
fn pairs(least_s: usize) -> Vec<Pair> {
    let all = (2..=LONGEST as usize).flat_map(|k| (0..=k).map(move |s| (s, k + 1 - s)));
    all.filter(|&(s, _)| s >= least_s).collect()
}

/// Some techniques, at least one for each length; by chance, as `number` says.
pub fn random_subset(spectrum: &Spectrum, number: u64) -> Vec<Pair> {
    let mut sampler = Sampler::numbered(0, number);
    let mut chosen = Vec::new();
    for &k in spectrum.by_length.keys() {
        let of_length: Vec<Pair> =
            spectrum.techniques.iter().copied().filter(|&(s, t)| s + t == k + 1).collect();
        let sure = (sampler.next_1d() * of_length.len() as f32) as usize;
        let by_chance = |(i, pair)| (i == sure || sampler.next_1d() < 0.4).then_some(pair);
        chosen.extend(of_length.into_iter().enumerate().filter_map(by_chance));
    }
    chosen
}

/// The amount to render.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Batches, at least two.
    pub batches: u32,
    /// Passes in a batch.
    pub passes: u32,
    /// Chance of a false alarm for each comparison.
    pub level: f64,
    /// The widest interval that counts as evidence, relative to the truth.
    pub equivalence: f64,
}

/// The mean over the film that each technique brings, a value a batch.
struct Pictures(BTreeMap<(Pair, bool), Vec<f64>>);

impl Pictures {
    fn render(spectrum: &Spectrum, weighting: Weighting, budget: Budget, seed: u64) -> Self {
        let limits = Limits { max_depth: Some(LONGEST), roulette: Roulette::OFF };
        let report = Report::Techniques;
        // The balance heuristic needs no raising, but either would do.
        let heuristic = Heuristic::Balance;
        let bdpt = Bdpt { limits, heuristic, weighting, report, ..Bdpt::default() };
        let mut pictures: BTreeMap<(Pair, bool), Vec<f64>> = BTreeMap::new();
        for batch in 0..budget.batches {
            let seed = seed + u64::from(batch);
            let settings = settings_by_pass(budget.passes, seed);
            let observe = &mut |_: &Progress<'_>| ControlFlow::Continue(());
            let rendering =
                render(&spectrum.case.scene, &bdpt, &settings, &Control::default(), observe);
            let rendering = rendering.expect("one thread");
            assert_eq!(rendering.statistics.rejected, 0);
            for (layer, mean) in rendering.film.develop_layers() {
                // No scene here has point lights and mirrors.
                let Technique { s, t, weighted, .. } = Technique::of_layer(layer);
                let values = pictures.entry(((s.into(), t.into()), weighted)).or_default();
                // A batch in which a technique found nothing has no picture of it.
                values.resize(batch as usize, 0.0);
                let sum: f64 = mean.values().iter().map(|rgb| f64::from(rgb.g)).sum();
                values.push(sum / mean.values().len() as f64);
            }
        }
        Self(pictures)
    }

    /// The sum of the weighted pictures of all techniques of a length.
    fn weighted_sum(&self, length: usize, budget: Budget) -> Vec<f64> {
        let mut sum = vec![0.0; budget.batches as usize];
        for (((s, t), weighted), values) in &self.0 {
            if *weighted && s + t == length + 1 {
                sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
            }
        }
        sum
    }
}

impl Spectrum {
    fn compare(&self, what: &str, length: usize, values: &[f64], budget: Budget) -> Finding {
        let truth = self.by_length[&length];
        let Interval { mean, half_width } = mean_interval(values, budget.level);
        let name = &self.case.name;
        let samples = u64::from(budget.batches * budget.passes);
        Finding {
            claim: format!("{name}, {length} edges: {what}"),
            statistic: format!("{mean:.6} ± {half_width:.6}, truth {truth:.6}"),
            level: Some(budget.level),
            samples: samples * samples_in_a_pass(&self.case.scene),
            holds: (mean - truth).abs() <= half_width + 2e-5 * truth
                && half_width <= budget.equivalence * truth,
        }
    }

    /// Each technique alone, unweighted, brings all light of its length; the
    /// weighted ones together bring it once.
    pub fn each_alone(&self, budget: Budget, seed: u64) -> Vec<Finding> {
        let pictures = Pictures::render(self, Weighting::Recursive, budget, seed);
        let none = vec![0.0; budget.batches as usize];
        let alone = self.techniques.iter().map(|&(s, t)| {
            let values = pictures.0.get(&((s, t), false)).unwrap_or(&none);
            self.compare(&format!("({s}, {t}) alone"), s + t - 1, values, budget)
        });
        let together = self
            .by_length
            .keys()
            .map(|&k| self.compare("all weighted", k, &pictures.weighted_sum(k, budget), budget));
        alone.chain(together).collect()
    }

    /// Some techniques, weighted among themselves, bring all light.
    pub fn subset(&self, chosen: &[Pair], budget: Budget, seed: u64) -> Vec<Finding> {
        let set = TechniqueSet::of(chosen.iter().copied().chain([(0, 2)]));
        let pictures = Pictures::render(self, Weighting::Among(set), budget, seed);
        let compare = |&k: &usize| {
            let of_length: Vec<Pair> =
                chosen.iter().copied().filter(|&(s, t)| s + t == k + 1).collect();
            let what = format!("{of_length:?} weighted");
            self.compare(&what, k, &pictures.weighted_sum(k, budget), budget)
        };
        self.by_length.keys().map(compare).collect()
    }
}
