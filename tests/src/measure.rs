//! Renderings as numbers: one a pass, and whether a known radiance is among
//! what they leave possible.

use crate::ledger::{Finding, settle};
use crate::statistics::{Interval, mean_interval, sidak};
use std::ops::ControlFlow;
use traylib_geometry::Vec3;
use traylib_integrators::{Control, Integrator, Method, Settings, Statistics, render};
use traylib_math::{Grid, Vec2};
use traylib_scene::{Camera, Scene};

/// How often the comparisons with known radiances, all of them together, raise
/// a false alarm.
pub const FAMILY_LEVEL: f64 = 1e-3;

/// At least as many as there are comparisons with known radiances in the whole
/// package. More widens every interval and makes false alarms rarer.
pub const FAMILY_SIZE: usize = 400;

/// The widest interval, on either side and relative to the truth, that counts
/// as evidence: agreement within an interval as wide as the picture is bright
/// would say nothing.
pub const EQUIVALENCE: f64 = 5e-3;

/// What single precision, the extent of a spot and truncated integrals may add,
/// relative to the truth. Decides alone where an estimator has no variance.
const ROUNDING: f64 = 2e-5;

/// A scene whose mean radiance over the film is known.
#[derive(Debug)]
pub struct Case {
    /// What it is called in a report.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The longest path, in edges.
    pub max_depth: Option<u32>,
    /// The mean radiance, in W/m²/sr.
    pub truth: f64,
}

/// Renders and hands every pass, on its own, to `observe`.
///
/// # Panics
/// If the system refuses a thread.
pub fn each_pass(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
    mut observe: impl FnMut(Grid<[f64; 3]>),
) -> Statistics {
    let mut before: Option<Grid<[f64; 3]>> = None;
    let rendering = render(scene, integrator, settings, &Control::default(), &mut |progress| {
        let passes = f64::from(progress.film.passes());
        let total = progress.film.mean().map(|mean| mean.map(|band| band * passes));
        let mut pass = total.clone();
        if let Some(before) = before.replace(total) {
            for (pass, before) in pass.values_mut().iter_mut().zip(before.values()) {
                for (pass, before) in pass.iter_mut().zip(before) {
                    *pass -= before;
                }
            }
        }
        observe(pass);
        ControlFlow::Continue(())
    });
    rendering.expect("one thread or two").statistics
}

/// The mean of the green band over the film, for each pass.
pub fn pass_means(
    scene: &Scene,
    integrator: &dyn Integrator,
    settings: &Settings,
) -> (Vec<f64>, Statistics) {
    let mut means = Vec::new();
    let statistics = each_pass(scene, integrator, settings, |pass| {
        let sum: f64 = pass.values().iter().map(|bands| bands[1]).sum();
        means.push(sum / pass.values().len() as f64);
    });
    (means, statistics)
}

/// Compares a method with the truth: every sample sound, the truth within the
/// interval of the family's level, and the interval narrow. The number of passes
/// and the seed are the caller's, fixed beforehand.
pub fn compare(case: &Case, method: Method, passes: u32, seed: u64) -> Finding {
    compare_within(case, method, passes, seed, EQUIVALENCE)
}

/// The same, where the interval may be as wide as `equivalence` to either side,
/// relative to the truth.
pub fn compare_within(
    case: &Case,
    method: Method,
    passes: u32,
    seed: u64,
    equivalence: f64,
) -> Finding {
    let integrator = method.up_to(case.max_depth).build();
    let settings = Settings { spp: passes, seed, threads: 1 };
    let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
    let samples = u64::from(passes) * samples_in_a_pass(&case.scene);
    let claim = format!("{}, {method}: mean radiance", case.name);
    judge(claim, &Measured { means, statistics, samples }, case.truth, equivalence)
}

/// What came of a rendering.
#[derive(Debug)]
pub struct Measured {
    /// A number for each pass.
    pub means: Vec<f64>,
    /// Tally of the work.
    pub statistics: Statistics,
    /// Samples behind all means together.
    pub samples: u64,
}

/// Holds the mean of all passes against the truth, as [`compare`] does; the
/// interval may be as wide as `equivalence` to either side, relative to the
/// truth.
pub fn judge(claim: String, measured: &Measured, truth: f64, equivalence: f64) -> Finding {
    let level = sidak(FAMILY_LEVEL, FAMILY_SIZE);
    let Interval { mean, half_width } = mean_interval(&measured.means, level);
    let wide = Interval { mean, half_width: half_width + ROUNDING * truth };
    let rejected = measured.statistics.rejected;
    let complaint = if rejected > 0 {
        format!(", {rejected} samples were not sound numbers")
    } else if !wide.contains(truth) {
        String::from(", the truth is not within")
    } else if half_width > equivalence * truth {
        String::from(", too wide to say anything")
    } else {
        String::new()
    };
    Finding {
        claim,
        statistic: if truth < 1e-3 {
            format!("{mean:.5e} ± {half_width:.1e}, truth {truth:.5e}{complaint}")
        } else {
            format!("{mean:.6} ± {half_width:.6}, truth {truth:.6}{complaint}")
        },
        level: Some(level),
        samples: measured.samples,
        holds: complaint.is_empty(),
    }
}

/// Camera samples, of which there are as many as light paths.
pub fn samples_in_a_pass(scene: &Scene) -> u64 {
    u64::from(scene.camera().width()) * u64::from(scene.camera().height())
}

/// [`compare`] for each of these methods, with its number of passes.
///
/// # Panics
/// With everything that did not hold.
pub fn all_hold(case: &Case, seed: u64, methods: &[(Method, u32)]) {
    let findings: Vec<Finding> =
        methods.iter().map(|&(method, passes)| compare(case, method, passes, seed)).collect();
    settle(&findings);
}

/// The mean over the film of what is seen at the points of the plane z = 0, by
/// the midpoint rule on 512 × 512 film points. The camera must see the plane
/// everywhere.
pub fn mean_over_floor(camera: &Camera, radiance: impl Fn(Vec3) -> f64) -> f64 {
    mean_over_film(camera, |origin, direction| {
        radiance(origin - direction * (origin.z / direction.z))
    })
}

/// The mean over the film of what is seen from the camera into a direction, by
/// the midpoint rule on 512 × 512 film points.
pub fn mean_over_film(camera: &Camera, radiance: impl Fn(Vec3, Vec3) -> f64) -> f64 {
    const STEPS: u32 = 512;
    let film = Vec2::new(camera.width() as f32, camera.height() as f32);
    let sum: f64 = (0..STEPS * STEPS)
        .map(|i| {
            let middle = Vec2::new((i % STEPS) as f32 + 0.5, (i / STEPS) as f32 + 0.5);
            let direction = camera.ray(film * middle / STEPS as f32).direction;
            radiance(camera.position(), direction)
        })
        .sum();
    sum / f64::from(STEPS * STEPS)
}
