//! From forecasts and trials to a plan.

use super::candidates::{Candidates, candidates};
use super::cost::price;
use super::evidence::{Choice, Evidence, TechniqueShare};
use super::forecast::{Forecast, forecast};
use super::length;
use super::means::Passes;
use super::pilot::Pilot;
use super::plan::Plan;
use super::probes::Probes;
use super::seen::LightsSeen;
use super::trial::{Trial, weights};
use super::work::Counted;
use crate::{Method, SceneFacts};

/// Methods that are tried for their forecasts; with those that always are there may be more.
pub(super) const TRIED: usize = 3;

/// The data that a choice is made from.
pub(super) struct Planner<'a> {
    pub(super) probes: &'a Probes<'a>,
    /// Some of the probes, on which methods are tried and work is counted.
    pub(super) some: Probes<'a>,
    pub(super) counted: Counted,
    pub(super) pilot: Pilot,
    pub(super) facts: SceneFacts,
    /// Passes of a trial.
    pub(super) passes: Passes,
    /// The noise of lights that the camera sees, which all methods share.
    pub(super) edges: f64,
}

impl Planner<'_> {
    /// The plan of paths that are not longer than this, for a picture of so many samples.
    pub(super) fn choose(mut self, max_depth: Option<u32>, samples: f64) -> Plan {
        let whole = Method::BDPT.up_to(max_depth);
        // All that may pay, the most promising first.
        let Candidates { methods, blind } = candidates(self.facts);
        let methods = methods.into_iter().map(|method| method.up_to(max_depth));
        let mut choices: Vec<Choice> = methods.map(|method| self.forecast(method)).collect();
        choices.retain(|choice| choice.forecast.is_finite());
        choices.sort_by(|a, b| a.expected().total_cmp(&b.expected()));
        // The first of them, and what is always worth a look, as they will be.
        let mut tried = Self::worth_trying(&choices, whole);
        self.try_out(&mut tried);
        // Without any noise the cheapest.
        let by_cost = |a: &Choice, b: &Choice| a.cost.total_cmp(&b.cost);
        tried.sort_by(|a, b| a.measured().total_cmp(&b.measured()).then(by_cost(a, b)));
        let method = tried.first().map_or(whole, |best| best.method);
        // Why: all choices, what the techniques of the best hold, and how long its paths are.
        let spent = self.samples(tried.len()) / samples;
        choices.retain(|choice| tried.iter().all(|tried| tried.method != choice.method));
        tried.append(&mut choices);
        let techniques = TechniqueShare::list(forecast(&self.pilot, method).shares);
        let beyond = length::lost_beyond(&length::light_by_edges(&self.pilot));
        let evidence = Evidence { choices: tried, blind, techniques, beyond, spent };
        Plan { method, evidence: Some(evidence) }
    }

    fn forecast(&mut self, method: Method) -> Choice {
        let Forecast { variance, .. } = forecast(&self.pilot, method);
        let work = self.counted.of(&self.some, method, self.passes.points);
        let cost = price(method, &work, self.probes.scene);
        Choice { method, forecast: variance + self.edges, tried: None, cost }
    }

    /// Finds the noise of these by trial, but for what is too rare to be tried.
    fn try_out(&self, choices: &mut [Choice]) {
        let (tiles, passes) = (&self.pilot.tiles, self.passes);
        let seen = LightsSeen::by(&self.some, passes);
        let trial = |choice: &Choice| Trial::run(&self.some, tiles, choice.method, &seen);
        let trials: Vec<Trial> = choices.iter().map(trial).collect();
        let weights = weights(&trials, tiles, &seen);
        for (choice, trial) in choices.iter_mut().zip(&trials) {
            let rare = forecast(&self.pilot, choice.method).rare;
            choice.tried = Some(trial.variance(&weights, passes) + self.edges + rare);
        }
    }

    /// The best by forecast, the best that has no light paths and the best that has, and the whole
    /// of bidirectional tracing.
    fn worth_trying(choices: &[Choice], whole: Method) -> Vec<Choice> {
        let walks = |choice: &&Choice| choice.method.techniques().need_light_paths();
        let of_kind = [
            choices.iter().find(walks),
            choices.iter().find(|choice| !walks(choice)),
            choices.iter().find(|choice| choice.method == whole),
        ];
        let mut tried: Vec<Choice> = Vec::new();
        for choice in of_kind.into_iter().flatten().chain(choices.iter().take(TRIED)) {
            if tried.iter().all(|other| other.method != choice.method) {
                tried.push(*choice);
            }
        }
        tried
    }

    /// Samples that all this took: of the pilot, of what was counted, and of so many trials.
    fn samples(&self, trials: usize) -> f64 {
        let pilot = self.pilot.samples() as usize;
        let trials = self.some.pixels.len() * self.passes.count as usize * trials;
        (pilot + trials + self.some.pixels.len() * self.counted.methods()) as f64
    }
}
