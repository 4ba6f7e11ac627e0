//! The choice of the method that pays on a scene: no more is modelled than it needs.
//!
//! Bidirectional tracing costs several times a path tracer's sample. Where lamps are large it
//! gains next to nothing, where they hide a path tracer never ends. [`plan`] finds out before
//! a picture is rendered, and spends a few hundredths of its samples on that:
//!
//! 1. *Facts* of the scene leave out what can find nothing there
//!    (`candidates`).
//! 2. A *pilot* by all techniques of bidirectional tracing notes every path with the
//!    densities of all techniques ([`FoundPath`](crate::FoundPath)). They tell the noise of every other set of
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
mod choose;
mod cost;
mod evidence;
mod forecast;
mod found;
mod grid;
mod length;
mod means;
mod pilot;
mod plan;
mod probes;
mod seen;
mod tiles;
mod trial;
mod work;

pub use cost::growth;
pub use evidence::{Choice, Evidence, TechniqueShare};
pub use forecast::Kind;
pub use plan::{Plan, Request};
pub use work::Work;

use crate::{Control, Method, PointSet, SceneFacts, ThreadError};
use choose::{Planner, TRIED};
use forecast::forecast;
use means::Passes;
use pilot::Pilot;
use probes::Probes;
use seen::LightsSeen;
use traylib_scene::Scene;
use work::Counted;

/// The part of the picture's samples that pilot and trials may take together.
const BUDGET: f64 = 0.035;

/// Fewer samples than these tell nothing.
const LEAST_PROBES: u32 = 256;

/// More of them tell no more.
const MOST_PROBES: u32 = 4096;

/// Passes of the pilot: two halves, each of which gives a mean of its own.
const PILOT_PASSES: u32 = 2;

/// Passes of a trial: sixteen in each of two sequences.
const TRIAL_PASSES: u32 = 32;

/// One of so many probes is tried, and counted.
const TRIED_PROBES: usize = 4;

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
    let pool = crate::thread_pool(request.threads)?;
    Ok(pool.install(|| {
        let probes = Probes::spread(scene, probes, request.seed, control);
        let passes = Passes { points: request.points, count: TRIAL_PASSES, spp: request.spp };
        let seen = LightsSeen::by(&probes, passes);
        let pilot = Pilot::run(&probes, request.max_depth, PILOT_PASSES, &seen);
        let max_depth = length::longest(&pilot, request);
        let edges = seen.noise(pilot.tiles.weights());
        let planner = Planner {
            probes: &probes,
            some: probes.one_of(TRIED_PROBES),
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
    let pool = crate::thread_pool(0)?;
    Ok(pool.install(|| {
        let probes = Probes::spread(scene, probes, seed, &control);
        let (points, count) = (PointSet::Independent, PILOT_PASSES);
        let seen = LightsSeen::by(&probes, Passes { points, count, spp: count });
        let pilot = Pilot::run(&probes, None, PILOT_PASSES, &seen);
        methods.iter().map(|&method| forecast(&pilot, method).variance).collect()
    }))
}

/// Counts the work of a method for a sample on a scene, as plans do.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn work(scene: &Scene, method: Method, points: PointSet) -> Result<Work, ThreadError> {
    let control = Control::default();
    let pool = crate::thread_pool(0)?;
    let probes = Probes::spread(scene, MOST_PROBES, 0, &control);
    Ok(pool.install(|| Counted::default().of(&probes, method, points)))
}

/// Samples of the picture.
fn samples(scene: &Scene, request: &Request) -> f64 {
    let camera = scene.camera();
    f64::from(camera.width()) * f64::from(camera.height()) * f64::from(request.spp)
}

/// Returns the number of pixels to ask; `None` if the picture is not worth it.
fn affordable(samples: f64) -> Option<u32> {
    // With those that are always tried.
    let tried = (TRIED + 2) as u32 * TRIAL_PASSES / TRIED_PROBES as u32;
    let passes = PILOT_PASSES + tried;
    let probes = (BUDGET * samples / f64::from(passes)) as u32;
    (probes >= LEAST_PROBES).then_some(probes.min(MOST_PROBES))
}
