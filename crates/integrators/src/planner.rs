//! Which method pays on a scene: no more is modelled than it needs.
//!
//! Bidirectional tracing costs several times a path tracer's sample. Where lamps are large it
//! gains next to nothing, where they hide a path tracer never ends. [`plan`] finds out before
//! a picture is rendered, and spends a few hundredths of its samples on that:
//!
//! 1. *Facts* of the scene leave out what can find nothing there
//!    (`candidates`).
//! 2. A *pilot* by all techniques of bidirectional tracing notes every path with the
//!    densities of all techniques ([`FoundPath`]). They tell the noise of every other set of
//!    techniques without rendering by it (`forecast`).
//! 3. What a sample costs is *counted*, never timed, and priced by a table (`cost`): the same
//!    command chooses the same method on every machine.
//! 4. Those of the least noise times cost are put to the test with the numbers that the
//!    picture will have (`trial`).
//!
//! The picture is rendered by the winner alone, and nothing of pilot and trials is in it: its
//! mean does not depend on how it was chosen. After Grittmann et al., *Efficiency-aware
//! multiple importance sampling for bidirectional rendering algorithms*, 2022, with variances
//! in place of second moments.

mod bands;
mod candidates;
mod cost;
mod evidence;
mod forecast;
mod found;
mod grid;
mod length;
mod means;
mod pilot;
mod probes;
mod tiles;
mod trial;
mod work;

pub use cost::{Price, growth, price};
pub use evidence::{Choice, Evidence, TechniqueShare};
pub use forecast::Kind;
pub use work::Work;

use crate::{Control, Method, PointSet, SceneFacts, ThreadError};
use candidates::{Candidates, candidates, without_images};
use forecast::{Forecast, RARE, forecast};
use means::Passes;
use pilot::Pilot;
use probes::Probes;
use traylib_scene::Scene;
use trial::{edges_of_lights, trial};
use work::Counted;

/// What is to be planned.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// The longest path, for the methods that are chosen from.
    pub max_depth: Option<u32>,
    /// The part of all light that longer paths may hold and lose: where it is above zero, a
    /// longest path is chosen, too.
    pub may_lose: f64,
    /// Samples a pixel of the picture, to spend a small part of them on the plan.
    pub spp: u32,
    /// Seed of the picture.
    pub seed: u64,
    /// Where the picture's numbers will come from.
    pub points: PointSet,
    /// Threads; 0 for one a processor. Does not change the plan.
    pub threads: usize,
}

/// What was chosen, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The method to render by.
    pub method: Method,
    /// What it was chosen for; `None` if the picture is too small to spend anything on it.
    pub evidence: Option<Evidence>,
}

/// The part of the picture's samples that pilot and trials may take together.
const BUDGET: f64 = 0.035;

/// Fewer samples than these tell nothing.
const LEAST_PROBES: u32 = 256;

/// More of them tell no more.
const MOST_PROBES: u32 = 4096;

/// Passes of the pilot: two halves, each of which gives a mean of its own.
const PILOT_PASSES: u32 = 2;

/// Passes of a trial: eight in each of four sequences.
const TRIAL_PASSES: u32 = 32;

/// One of so many probes is tried.
const TRIED_PROBES: usize = 4;

/// One of so many is counted.
const COUNTED_PROBES: usize = 4;

/// Methods that are tried; with the safe one and those without images there may be more.
const TRIED: usize = 3;

/// Chooses the method that reaches a given error soonest.
///
/// The choice depends on the scene, the request and nothing else. `None` if `control` was
/// cancelled meanwhile.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn plan(
    scene: &Scene,
    request: &Request,
    control: &Control,
) -> Result<Option<Plan>, ThreadError> {
    let safe = Plan { method: Method::BDPT.up_to(request.max_depth), evidence: None };
    let samples = samples(scene, request);
    let Some(probes) = affordable(samples) else { return Ok(Some(safe)) };
    let pool = crate::render::pool(request.threads)?;
    Ok(pool.install(|| {
        let probes = Probes::spread(scene, probes, request.seed, control);
        let pilot = Pilot::run(&probes, request.max_depth, PILOT_PASSES);
        let max_depth = length::longest(&pilot, request);
        let passes = Passes { points: request.points, count: TRIAL_PASSES, spp: request.spp };
        let edges = edges_of_lights(&probes, &pilot.tiles, passes);
        let planner = Planner {
            probes: &probes,
            quarter: probes.one_of(TRIED_PROBES),
            few: probes.one_of(COUNTED_PROBES),
            counted: Counted::default(),
            pilot,
            facts: SceneFacts::of(scene),
            passes,
            edges,
        };
        let plan = planner.choose(max_depth, samples);
        (!control.is_cancelled()).then_some(plan)
    }))
}

/// The variance of one sample by each of these methods, relative as relMSE is, as the pilot of a
/// plan has it that asks so many pixels: infinite for one that cannot find what was found.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn forecasts(
    scene: &Scene,
    methods: &[Method],
    probes: u32,
    seed: u64,
) -> Result<Vec<f64>, ThreadError> {
    let control = Control::default();
    let pool = crate::render::pool(0)?;
    Ok(pool.install(|| {
        let pilot = Pilot::run(&Probes::spread(scene, probes, seed, &control), None, PILOT_PASSES);
        methods.iter().map(|&method| forecast(&pilot, method).variance).collect()
    }))
}

/// What a method does for a sample on a scene, as plans count it.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn work(scene: &Scene, method: Method, points: PointSet) -> Result<Work, ThreadError> {
    let control = Control::default();
    let pool = crate::render::pool(0)?;
    let probes = Probes::spread(scene, MOST_PROBES, 0, &control);
    Ok(pool.install(|| Counted::default().of(&probes, method, points)))
}

/// Samples of the picture.
fn samples(scene: &Scene, request: &Request) -> f64 {
    let camera = scene.camera();
    f64::from(camera.width()) * f64::from(camera.height()) * f64::from(request.spp)
}

/// How many pixels to ask, if the picture is worth it.
fn affordable(samples: f64) -> Option<u32> {
    // With the three kinds that are always tried.
    let tried = (TRIED + 2) as u32 * TRIAL_PASSES / TRIED_PROBES as u32;
    let passes = PILOT_PASSES + tried;
    let probes = (BUDGET * samples / f64::from(passes)) as u32;
    (probes >= LEAST_PROBES).then_some(probes.min(MOST_PROBES))
}

/// What a choice is made from.
struct Planner<'a> {
    probes: &'a Probes<'a>,
    /// Some of the probes, on which methods are tried.
    quarter: Probes<'a>,
    /// Fewer, on which work is counted.
    few: Probes<'a>,
    counted: Counted,
    pilot: Pilot,
    facts: SceneFacts,
    passes: Passes,
    /// The noise of lights that the camera sees, which all methods share.
    edges: f64,
}

impl Planner<'_> {
    /// The plan of paths that are not longer than this, for a picture of so many samples.
    fn choose(mut self, max_depth: Option<u32>, samples: f64) -> Plan {
        let whole = Method::BDPT.up_to(max_depth);
        // All that may pay, the most promising first.
        let Candidates { methods, blind } = candidates(self.facts);
        let methods = methods.into_iter().map(|method| method.up_to(max_depth));
        let mut choices: Vec<Choice> = methods.map(|method| self.forecast(method)).collect();
        choices.retain(|choice| choice.forecast.is_finite());
        choices.sort_by(|a, b| a.expected().total_cmp(&b.expected()));
        // The first of them, and what is always worth a look, as they will be.
        let mut tried = self.worth_trying(&choices, whole);
        for choice in &mut tried {
            choice.tried = Some(self.try_out(choice.method));
        }
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
        let work = self.counted.of(&self.few, method, self.passes.points);
        let cost = price(method, &work, self.probes.scene);
        Choice { method, forecast: variance + self.edges, tried: None, cost }
    }

    /// The noise of a method by trial, but for what is too rare to be tried.
    fn try_out(&self, method: Method) -> f64 {
        let tried =
            |clip| trial(&self.quarter, &self.pilot.tiles, method, self.passes, clip) + self.edges;
        // What directlight aims at in mirrors the pilot does not know of.
        let is_known =
            method.techniques().need_light_paths() || !self.probes.scene.lights_are_small();
        if is_known {
            tried(RARE) + forecast(&self.pilot, method).rare
        } else {
            tried(f64::INFINITY)
        }
    }

    /// The best by forecast, the best that has no light paths and the best that has, the whole
    /// of bidirectional tracing; and where mirrors show lamps the first of them without
    /// looking for those images.
    fn worth_trying(&mut self, choices: &[Choice], whole: Method) -> Vec<Choice> {
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
        if self.probes.scene.lights_are_small() {
            let first = choices.first().and_then(|c| without_images(c.method, self.facts));
            tried.extend(first.map(|method| self.forecast(method)));
        }
        tried
    }

    /// Samples that all this took: of the pilot, of what was counted, and of so many trials.
    fn samples(&self, trials: usize) -> f64 {
        let pilot = self.probes.pixels.len() * PILOT_PASSES as usize;
        let trials = self.quarter.pixels.len() * TRIAL_PASSES as usize * trials;
        (pilot + trials + self.few.pixels.len() * self.counted.methods()) as f64
    }
}
