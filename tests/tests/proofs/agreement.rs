//! The programs against one another on the project's scenes; how, stands in
//! `traylib_tests::agreement`.

use traylib_io::{LoadOptions, load_scene_with};
use traylib_tests::agreement::{Agreement, Budget, Other, Subject, agree, evenness};
use traylib_tests::ledger::{Finding, settle};
use traylib_tests::programs::Program::{self, BdptBalance, Combined, Particle, PureMc, Strict};

fn agreement(name: &str, others: &[Other], budget: &Budget) -> Agreement {
    let options = LoadOptions { resolution: Some((48, 36)) };
    let scene = load_scene_with(name, options).unwrap().scene;
    agree(&Subject { name, scene: &scene }, others, budget)
}

const fn other(program: Program, passes: u32, promise: f64) -> Other {
    Other { program, passes, promise }
}

/// In the short form passes may not even have met rare light, so the pairs are
/// chosen so that there is none. On `plates` the edges of lamps seen directly
/// make the mean uncertain; the tiles without them are not.
#[test]
fn programs_agree() {
    let budget = Budget { tile: 12, looks: vec![96] };
    let pairs = [
        ("cornell", vec![other(Combined, 4, 0.04), other(PureMc, 8, 0.04)]),
        ("pyramid", vec![other(Particle, 1, 0.1)]),
        ("plates", vec![other(Combined, 4, 0.15)]),
    ];
    let findings: Vec<Finding> =
        pairs.iter().flat_map(|(name, others)| agreement(name, others, &budget).findings).collect();
    settle(&findings);
}

/// How closely each program is held to `bdpt` on a scene: 0.5 % of the mean, or
/// what its noise leaves after the last look.
struct Held {
    scene: &'static str,
    combined: f64,
    balance: f64,
    strict: f64,
    puremc: f64,
    particle: f64,
}

impl Held {
    /// All to 0.5 %.
    const fn closely(scene: &'static str) -> Self {
        let same = 5e-3;
        Self { scene, combined: same, balance: same, strict: same, puremc: same, particle: same }
    }

    fn others(&self) -> [Other; 5] {
        [
            other(Combined, 4, self.combined),
            other(BdptBalance, 1, self.balance),
            other(Strict, 4, self.strict),
            other(PureMc, 8, self.puremc),
            other(Particle, 1, self.particle),
        ]
    }
}

const HELD: [Held; 9] = [
    Held::closely("cornell"),
    Held::closely("small-light"),
    Held::closely("pyramid"),
    Held::closely("plates"),
    Held::closely("furnace"),
    Held::closely("hangar"),
    Held::closely("office-lamps"),
    Held::closely("reference-a"),
    Held::closely("reference-c"),
];

/// Every scene with area lamps and every program that can render it.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn all_programs_agree_on_all_scenes() {
    let budget = Budget { tile: 12, looks: vec![128, 512, 2048] };
    let agreements: Vec<Agreement> =
        HELD.iter().map(|held| agreement(held.scene, &held.others(), &budget)).collect();
    let mut findings: Vec<Finding> =
        agreements.iter().flat_map(|agreement| agreement.findings.clone()).collect();
    findings.push(evenness(Combined, &agreements));
    settle(&findings);
}
