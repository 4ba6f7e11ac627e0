//! Closed rooms again: glossy walls, a ball in a ball, all walls of a room. The
//! derivations stand in `traylib_tests::{rooms, concentric}`; the comparisons
//! belong to one family with those of `analytic.rs`.

use traylib_integrators::{Settings, Statistics};
use traylib_tests::known::concentric::{Shell, concentric};
use traylib_tests::known::rooms::{glossy_ball, room_of_flux};
use traylib_tests::ledger::{Finding, settle};
use traylib_tests::measure::{EQUIVALENCE, Measured, all_hold, compare, judge, pass_means};
use traylib_tests::programs::Program::{
    self, BdptBalance, BdptPower, Combined, Particle, PureMc, Strict,
};

#[test]
fn b3_glossy_ball() {
    for (seed, exponent, degrees) in [(131, 1.0, 30.0), (132, 20.0, 80.0), (133, 1e3, 60.0)] {
        all_hold(&glossy_ball(exponent, degrees), seed, &[(PureMc, 32), (BdptPower, 32)]);
    }
}

/// Without the strict `directlight` for the sharp lobe: lamps all around give it
/// cv² = n/4.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn b3_glossy_ball_at_all_angles() {
    let programs = [(PureMc, 64), (Combined, 64), (BdptPower, 64), (BdptBalance, 64)];
    for (seed, exponent) in [(134, 1.0), (135, 20.0), (136, 1e3)] {
        for degrees in [0.0, 60.0, 85.0] {
            let case = glossy_ball(exponent, degrees);
            all_hold(&case, seed, &programs);
            if exponent < 1e3 {
                all_hold(&case, seed, &[(Strict, 320)]);
            }
        }
    }
}

#[test]
fn b6_ball_in_a_ball() {
    let lengths = [(Some(2), 64), (Some(3), 64), (Some(4), 64), (Some(5), 100), (None, 300)];
    for (depth, passes) in lengths {
        let case = concentric(Shell::Inner, Shell::Outer, depth);
        all_hold(&case, 161, &[(BdptPower, passes)]);
    }
}

/// Either one glows, and either one is seen. Few light paths come into so narrow
/// a view: one case for the particle tracer; and light samples without weights
/// are dear between balls.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn b6_by_all_programs() {
    let mut findings = Vec::new();
    for lamp in [Shell::Inner, Shell::Outer] {
        for seen in [Shell::Inner, Shell::Outer] {
            for depth in [Some(3), Some(4), Some(5), None] {
                let case = concentric(lamp, seen, depth);
                let both = [BdptPower, BdptBalance];
                findings.extend(both.map(|program| compare(&case, program, 500, 162)));
            }
            findings.push(compare(&concentric(lamp, seen, Some(4)), Strict, 3200, 164));
        }
    }
    let case = concentric(Shell::Inner, Shell::Outer, Some(4));
    let others = [(PureMc, 4200), (Combined, 500), (Particle, 24_000)];
    findings.extend(others.map(|(program, passes)| compare(&case, program, passes, 163)));
    settle(&findings);
}

/// The mean over the six walls of one pass each.
fn all_walls(program: Program, passes: u32, seed: u64) -> Finding {
    let cases = room_of_flux();
    let mut all = Measured {
        means: vec![0.0; passes as usize],
        statistics: Statistics::default(),
        samples: 6 * 1024 * u64::from(passes),
    };
    for (i, case) in (0..).zip(&cases) {
        let settings = Settings { spp: passes, seed: seed + i, threads: 1 };
        let integrator = program.integrator(case.max_depth);
        let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
        all.statistics += statistics;
        all.means.iter_mut().zip(means).for_each(|(mean, wall)| *mean += wall / 6.0);
    }
    judge(format!("B7, {program:?}: mean over all walls"), &all, cases[0].truth, EQUIVALENCE)
}

#[test]
fn b7_all_walls_of_a_room() {
    settle(&[all_walls(BdptPower, 40, 171), all_walls(Particle, 340, 177)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn b7_by_all_programs() {
    let programs = [PureMc, Strict, Combined, BdptPower, BdptBalance, Particle];
    settle(&programs.map(|program| all_walls(program, 400, 180)));
}
