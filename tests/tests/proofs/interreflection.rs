//! Closed rooms again: glossy walls, a ball in a ball, all walls of a room. The
//! derivations stand in `traylib_tests::{rooms, concentric}`; the comparisons
//! belong to one family with those of `analytic.rs`.

use traylib_integrators::{Method, Statistics};
use traylib_known::concentric::{Shell, concentric};
use traylib_known::rooms::{glossy_ball, room_of_flux};
use traylib_known::{pass_means, settings_by_pass};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::measure::{EQUIVALENCE, Measured, all_hold, compare, judge};
use traylib_tests::methods::{
    BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC, WALKING,
};

#[test]
fn b3_glossy_ball() {
    for (seed, exponent, degrees) in [(131, 1.0, 30.0), (132, 20.0, 80.0), (133, 1e3, 60.0)] {
        all_hold(&glossy_ball(exponent, degrees), seed, &[(PURE_MC, 32), (BDPT, 32)]);
    }
}

/// Without the strict `directlight` for the sharp lobe: lamps all around give it
/// cv² = n/4.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn b3_glossy_ball_at_all_angles() {
    let methods = [(PURE_MC, 64), (COMBINED, 64), (BDPT, 64), (BDPT_BALANCE, 64)];
    for (seed, exponent) in [(134, 1.0), (135, 20.0), (136, 1e3)] {
        for degrees in [0.0, 60.0, 85.0] {
            let case = glossy_ball(exponent, degrees);
            all_hold(&case, seed, &methods);
            if exponent < 1e3 {
                all_hold(&case, seed, &[(DIRECT_LIGHT, 320)]);
            }
        }
    }
}

#[test]
fn b6_ball_in_a_ball() {
    let lengths = [(Some(2), 64), (Some(3), 64), (Some(4), 64), (Some(5), 100), (None, 300)];
    for (depth, passes) in lengths {
        let case = concentric(Shell::Inner, Shell::Outer, depth);
        all_hold(&case, 161, &[(BDPT, passes)]);
    }
}

/// Either one glows, and either one is seen. Few light paths come into so narrow
/// a view: one case for the particle tracer; and light samples without weights
/// are dear between balls.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn b6_by_all_methods() {
    let mut findings = Vec::new();
    for lamp in [Shell::Inner, Shell::Outer] {
        for seen in [Shell::Inner, Shell::Outer] {
            for depth in [Some(3), Some(4), Some(5), None] {
                let case = concentric(lamp, seen, depth);
                let both = [BDPT, BDPT_BALANCE];
                findings.extend(both.map(|method| compare(&case, method, 500, 162)));
            }
            findings.push(compare(&concentric(lamp, seen, Some(4)), DIRECT_LIGHT, 3200, 164));
        }
    }
    let case = concentric(Shell::Inner, Shell::Outer, Some(4));
    let others = [(PURE_MC, 4200), (COMBINED, 500), (PARTICLE, 24_000)];
    findings.extend(others.map(|(method, passes)| compare(&case, method, passes, 163)));
    settle(&findings);
}

/// The mean over the six walls of one pass each.
fn all_walls(method: Method, passes: u32, seed: u64) -> Finding {
    let cases = room_of_flux();
    let mut all = Measured {
        means: vec![0.0; passes as usize],
        statistics: Statistics::default(),
        samples: 6 * 1024 * u64::from(passes),
    };
    for (i, case) in (0..).zip(&cases) {
        let settings = settings_by_pass(passes, seed + i);
        let integrator = method.up_to(case.max_depth).build();
        let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
        all.statistics += statistics;
        all.means.iter_mut().zip(means).for_each(|(mean, wall)| *mean += wall / 6.0);
    }
    judge(format!("B7, {method}: mean over all walls"), &all, cases[0].truth, EQUIVALENCE)
}

#[test]
fn b7_all_walls_of_a_room() {
    settle(&[all_walls(BDPT, 40, 171), all_walls(PARTICLE, 340, 177)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn b7_by_all_methods() {
    settle(&WALKING.map(|method| all_walls(method, 400, 180)));
}
