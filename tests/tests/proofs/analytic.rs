//! Direct light against closed forms; what they are and why stands in
//! `traylib_tests::known::analytic`.
//!
//! All comparisons here and in `furnace.rs` are one family, for which a correct
//! renderer raises a false alarm with probability 10⁻³
//! ([`FAMILY_LEVEL`](traylib_tests::measure::FAMILY_LEVEL)); each must also settle
//! its radiance to 0.5 %. The numbers of passes follow from the relative
//! deviation cv of one sample: about 1.2·10⁶·cv² samples, of which a pass over a
//! spot has 4096 and one over a wide view 1024; and at least 32 passes.

use traylib_integrators::{Settings, Trace};
use traylib_tests::known::analytic::{
    disk, max_phong_disk, outshone, phong_disk, point_light, point_light_wide, sphere, square,
    square_wide,
};
use traylib_tests::ledger::settle;
use traylib_tests::measure::{Case, all_hold, compare_within, each_pass};
use traylib_tests::programs::Program::{
    self, BdptBalance, BdptPower, Combined, Particle, PureMc, Strict,
};

/// Those that combine ways to find the lamp, and so need few passes anywhere.
const REST: [(Program, u32); 3] = [(Combined, 80), (BdptPower, 80), (BdptBalance, 80)];

/// Nothing is random here: every pixel is right by itself, up to how much the
/// radiance changes over a spot of 4·10⁻⁵ m.
#[test]
fn trace_is_exact_under_a_point_light() {
    let Case { scene, truth, .. } = point_light();
    let settings = Settings { spp: 1, seed: 0, threads: 1 };
    let statistics = each_pass(&scene, &Trace::default(), &settings, |image| {
        for radiance in image.values().iter().flatten() {
            assert!((radiance / truth - 1.0).abs() < 4e-5, "{radiance} {truth}");
        }
    });
    assert_eq!(statistics.rejected, 0);
}

#[test]
fn a1_point_light() {
    all_hold(&point_light(), 11, &Program::FROM_CAMERA.map(|program| (program, 32)));
}

/// Light paths find a spot by the rarest chance, so the particle tracer is asked
/// about wide views.
#[test]
fn a1_point_light_in_a_wide_view() {
    let programs = [(Particle, 1800), (BdptPower, 900), (BdptBalance, 900), (PureMc, 128)];
    all_hold(&point_light_wide(), 12, &programs);
}

/// A thirty-third of the light paths start at the light: what is left of a floor of a
/// sixteenth for each of two lamps. So many fewer say the mean to 5 %, not 0.5 %.
#[test]
fn a1_outshone() {
    let case = outshone();
    let compare = |program| compare_within(&case, program, 1800, 13, 0.05);
    settle(&[Particle, BdptPower].map(compare));
}

/// Without `puremc`: it hits so small a lamp once in a hundred times, cv = 10.
#[test]
fn a2_small_disk() {
    let programs = [(Strict, 32), (Combined, 32), (BdptPower, 32), (BdptBalance, 64)];
    all_hold(&disk(0.1), 21, &programs);
}

#[test]
fn a2_disk() {
    all_hold(&disk(1.0), 22, &[(PureMc, 320), (Strict, 64), REST[0], REST[1], REST[2]]);
}

/// Light sampling by area has cv² = 2.7 so close under a large lamp.
#[test]
fn a2_large_disk() {
    all_hold(&disk(3.0), 23, &[(PureMc, 64), (Strict, 800), REST[0], REST[1], REST[2]]);
}

#[test]
fn a3_sphere() {
    all_hold(&sphere(), 31, &[(PureMc, 1200), (Strict, 64), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_square() {
    all_hold(&square(1.0), 51, &[(PureMc, 256), (Strict, 96), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_small_square() {
    all_hold(&square(0.5), 52, &[(PureMc, 1000), (Strict, 64), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_square_in_a_wide_view() {
    let programs = [(Particle, 1250), (BdptPower, 400), (BdptBalance, 400), (Combined, 400)];
    all_hold(&square_wide(), 53, &programs);
}

#[test]
fn a8_phong() {
    let programs = [(PureMc, 320), (Strict, 128), REST[0], REST[1], REST[2]];
    all_hold(&phong_disk(10.0, 0.5), 81, &programs);
    all_hold(&phong_disk(1e3, 0.05), 82, &programs);
    all_hold(&phong_disk(1e6, 0.002), 83, &programs);
}

#[test]
fn a8_max_phong() {
    let programs = [(PureMc, 128), (Strict, 128), REST[0], REST[1], REST[2]];
    all_hold(&max_phong_disk(10.0, 0.5), 84, &programs);
    all_hold(&max_phong_disk(1e3, 0.05), 85, &programs);
    all_hold(&max_phong_disk(1e6, 0.002), 86, &programs);
}
