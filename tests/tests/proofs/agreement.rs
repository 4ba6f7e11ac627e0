//! The methods against one another on the project's scenes; how, stands in
//! `traylib_tests::agreement`.

use traylib_integrators::Method;
use traylib_io::{LoadOptions, load_scene_with};
use traylib_tests::agreement::{Agreement, Budget, Other, Subject, agree, evenness};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::methods::{BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};
use traylib_tests::methods::{finds_by_chance, walks_from_lights};

fn agreement(name: &str, others: &[Other], budget: &Budget) -> Agreement {
    let options = LoadOptions { resolution: Some((48, 36)), ..LoadOptions::default() };
    let scene = load_scene_with(name, options).unwrap().scene;
    agree(&Subject { name, scene: &scene }, others, budget)
}

const fn other(method: Method, passes: u32, promise: f64) -> Other {
    Other { method, passes, promise }
}

/// In the short form passes may not even have met rare light, so the pairs are
/// chosen so that there is none. On `plates` the edges of lamps seen directly
/// make the mean uncertain; the tiles without them are not.
#[test]
fn methods_agree() {
    let budget = Budget { tile: 12, looks: vec![96] };
    let pairs = [
        ("cornell", vec![other(COMBINED, 4, 0.04), other(PURE_MC, 8, 0.04)]),
        // `directlight` finds what the pyramid throws by aiming at images of its lamp.
        ("pyramid", vec![other(PARTICLE, 1, 0.1), other(COMBINED, 4, 0.1)]),
        ("plates", vec![other(COMBINED, 4, 0.15)]),
    ];
    let findings: Vec<Finding> =
        pairs.iter().flat_map(|(name, others)| agreement(name, others, &budget).findings).collect();
    settle(&findings);
}

/// The relative difference that the means may have, the interval included.
const SAME: f64 = 5e-3;

/// Every method whose light on this scene has a usable variance, to 0.5 % of the
/// mean or to what its noise leaves after the last look.
///
/// Left out are `directlight` and `particle` on `cornell` and `small-light`:
/// the balls' lobes are so sharp that samples which find the lamp in them are
/// enormous and too rare to be met at all, so what was met looks steady and lacks
/// light. Likewise `particle` on `hangar`, for the glints in its floor.
fn all_agree(scene: &str, others: &[Other]) {
    let budget = Budget { tile: 12, looks: vec![128, 512, 2048] };
    settle(&agreement(scene, others, &budget).findings);
}

/// With the same promise, and passes that take about the same time.
fn alike<const N: usize>(methods: [Method; N], promise: f64) -> [Other; N] {
    methods.map(|method| {
        let passes = if walks_from_lights(method) {
            1
        } else if finds_by_chance(method) {
            8
        } else {
            4
        };
        other(method, passes, promise)
    })
}

const EVERY: [Method; 5] = [COMBINED, BDPT_BALANCE, DIRECT_LIGHT, PURE_MC, PARTICLE];

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_cornell() {
    all_agree("cornell", &alike([COMBINED, BDPT_BALANCE, PURE_MC], SAME));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_small_light() {
    all_agree("small-light", &alike([COMBINED, BDPT_BALANCE, PURE_MC], 0.1));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_pyramid() {
    let from_lamp = [other(BDPT_BALANCE, 1, SAME), other(PARTICLE, 1, 0.01)];
    let walks = [other(PURE_MC, 16, 0.06)];
    let others = [&alike([COMBINED, DIRECT_LIGHT], 0.06)[..], &walks, &from_lamp].concat();
    all_agree("pyramid", &others);
}

/// The edges of lamps seen directly make the mean uncertain.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_plates() {
    all_agree("plates", &alike(EVERY, 0.15));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_furnace() {
    all_agree("furnace", &alike(EVERY, SAME));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_hangar() {
    let strict = other(DIRECT_LIGHT, 8, 0.015);
    all_agree(
        "hangar",
        &[&alike([COMBINED, BDPT_BALANCE, PURE_MC], 0.015)[..], &[strict]].concat(),
    );
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_office_lamps() {
    all_agree("office-lamps", &alike(EVERY, 0.0125));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_reference_a() {
    all_agree("reference-a", &alike(EVERY, SAME));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_reference_c() {
    let noisy = [other(DIRECT_LIGHT, 8, SAME), other(PURE_MC, 16, 0.02)];
    let others = [&alike([COMBINED, BDPT_BALANCE, PARTICLE], SAME)[..], &noisy].concat();
    all_agree("reference-c", &others);
}

/// A bias too small for any one tile would pull all probabilities to one side.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn probabilities_are_even() {
    let budget = Budget { tile: 4, looks: vec![256] };
    let others = [other(COMBINED, 4, 1.0)];
    let scenes = ["cornell", "office-lamps", "reference-a"];
    let agreements: Vec<Agreement> =
        scenes.iter().map(|name| agreement(name, &others, &budget)).collect();
    settle(&[evenness(COMBINED, &agreements)]);
}
