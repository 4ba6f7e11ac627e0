//! Limits on paths: what a number of edges means, and that roulette loses
//! nothing.
//!
//! In a glowing ball every way to find light has the same value: walks meet the
//! same radiance everywhere, and two patches exchange the same share of light
//! wherever they are. So without roulette the methods that walk from the camera
//! have no variance but that of splats, and one edge too many or too few stands
//! out at any number of samples.

use traylib_integrators::{Limits, Method, Roulette};
use traylib_known::furnace::{
    central_light, diffuse_walls, glowing_ball, mirroring_walls, offset_light_wide,
};
use traylib_known::{Case, pass_means, samples_in_a_pass, settings_by_pass};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::verdict::{Known, has_mean};
use traylib_tests::methods;

/// The error that rounding may add, relative to the truth.
const ROUNDING: f64 = 2e-5;

/// The mean radiance of the case, by a method with these limits; `widest` is
/// relative.
fn finding(case: &Case, method: Method, roulette: Roulette, passes: u32, widest: f64) -> Finding {
    let limits = Limits { max_depth: case.max_depth, roulette };
    let integrator = method.with_limits(limits).build();
    let settings = settings_by_pass(passes, 191);
    let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
    let claim = format!("{}, {method}, roulette from {}", case.name, roulette.from_edge);
    assert_eq!(statistics.rejected, 0, "{claim}");
    let [slack, widest] = [ROUNDING, widest].map(|part| part * case.truth);
    let known = Known { truth: case.truth, slack, widest };
    has_mean(claim, &means, known, u64::from(passes) * samples_in_a_pass(&case.scene))
}

/// Every number of edges. The last reflection's share of the light is at least
/// 2⁻⁶, so an interval of 0.4 % tells each from its neighbours.
fn length_laws(passes: u32, widest: f64) {
    let mut findings = Vec::new();
    for edges in 1..=6 {
        let glow = glowing_ball(diffuse_walls(), Some(edges));
        findings.extend(methods::WALKING.map(|method| {
            finding(&glow, method, Roulette::OFF, passes_of(method, passes), widest)
        }));
    }
    settle(&findings);
}

/// The particle tracer's light is all in splats.
fn passes_of(method: Method, passes: u32) -> u32 {
    if methods::splats_alone(method) { 8 * passes } else { passes }
}

#[test]
fn lengths_are_counted_in_edges() {
    length_laws(16, 0.02);
}

/// With a point light in the middle, where light paths begin with one more kind
/// of density, and beside it; and where part of the walk is mirrored.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn lengths_are_counted_in_edges_at_length() {
    length_laws(160, 4e-3);
    let mut findings = Vec::new();
    for edges in 2..=6 {
        for case in [central_light(Some(edges)), offset_light_wide(Some(edges))] {
            findings.extend(
                methods::WALKING.map(|method| {
                    finding(&case, method, Roulette::OFF, passes_of(method, 160), 1e-2)
                }),
            );
        }
    }
    settle(&findings);
}

/// Roulette that may end every walk after its first edge, from either end and
/// from both.
fn roulette_laws(passes: u32, widest: f64) {
    let early = Roulette { from_edge: 2 };
    let glow = glowing_ball(diffuse_walls(), None);
    let mirrors = glowing_ball(mirroring_walls(), None);
    let mut findings: Vec<Finding> = methods::WALKING
        .map(|method| finding(&glow, method, early, passes_of(method, passes), widest))
        .into();
    // The particle tracer cannot see what a mirror shows.
    let seeing = methods::WALKING.into_iter().filter(|&method| !methods::splats_alone(method));
    findings.extend(seeing.map(|method| finding(&mirrors, method, early, passes, widest)));
    settle(&findings);
}

#[test]
fn early_roulette_loses_nothing() {
    roulette_laws(64, 0.03);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn early_roulette_loses_nothing_at_length() {
    roulette_laws(1000, 5e-3);
}
