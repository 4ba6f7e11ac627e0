//! Direct light against closed forms; what they are and why stands in
//! `traylib_known::analytic`.
//!
//! All comparisons here and in `furnace.rs` are one family, for which a correct
//! renderer raises a false alarm with probability 10⁻³
//! ([`FAMILY_LEVEL`](traylib_tests::measure::FAMILY_LEVEL)); each must also settle
//! its radiance to 0.5 %. The numbers of passes follow from the relative
//! deviation cv of one sample: about 1.2·10⁶·cv² samples, of which a pass over a
//! spot has 4096 and one over a wide view 1024; and at least 32 passes.

use traylib_integrators::{Method, Settings, Trace};
use traylib_known::analytic::{
    disk, max_phong_disk, outshone, phong_disk, point_light, point_light_wide, sphere, square,
    square_wide,
};
use traylib_known::{Case, each_pass};
use traylib_tests::findings::settle;
use traylib_tests::measure::{all_hold, compare_within};
use traylib_tests::methods::{self, BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// The methods that combine ways to find the lamp, and so need few passes anywhere.
const REST: [(Method, u32); 3] = [(COMBINED, 80), (BDPT, 80), (BDPT_BALANCE, 80)];

/// Nothing is random here: every pixel is right by itself, up to how much the
/// radiance changes over a spot of 4·10⁻⁵ m.
#[test]
fn trace_is_exact_under_a_point_light() {
    let Case { scene, truth, .. } = point_light();
    let settings = Settings { spp: 1, seed: 0, threads: 1, ..Settings::default() };
    let statistics = each_pass(&scene, &Trace::default(), &settings, |image| {
        for radiance in image.values().iter().flatten() {
            assert!((radiance / truth - 1.0).abs() < 4e-5, "{radiance} {truth}");
        }
    });
    assert_eq!(statistics.rejected, 0);
}

#[test]
fn a1_point_light() {
    all_hold(&point_light(), 11, &methods::from_camera(32));
}

/// Light paths find a spot by the rarest chance, so the particle tracer is asked
/// about wide views.
#[test]
fn a1_point_light_in_a_wide_view() {
    let methods = [(PARTICLE, 1800), (BDPT, 900), (BDPT_BALANCE, 900), (PURE_MC, 128)];
    all_hold(&point_light_wide(), 12, &methods);
}

/// A thirty-third of the light paths start at the light: what is left of a floor of a
/// sixteenth for each of two lamps. So many fewer say the mean to 5 %, not 0.5 %.
#[test]
fn a1_outshone() {
    let case = outshone();
    let compare = |method| compare_within(&case, method, 1800, 13, 0.05);
    settle(&[PARTICLE, BDPT].map(compare));
}

/// Without `puremc`: it hits so small a lamp once in a hundred times, cv = 10.
#[test]
fn a2_small_disk() {
    let methods = [(DIRECT_LIGHT, 32), (COMBINED, 32), (BDPT, 32), (BDPT_BALANCE, 64)];
    all_hold(&disk(0.1), 21, &methods);
}

#[test]
fn a2_disk() {
    all_hold(&disk(1.0), 22, &[(PURE_MC, 320), (DIRECT_LIGHT, 64), REST[0], REST[1], REST[2]]);
}

/// Light sampling by area has cv² = 2.7 so close under a large lamp.
#[test]
fn a2_large_disk() {
    all_hold(&disk(3.0), 23, &[(PURE_MC, 64), (DIRECT_LIGHT, 800), REST[0], REST[1], REST[2]]);
}

#[test]
fn a3_sphere() {
    all_hold(&sphere(), 31, &[(PURE_MC, 1200), (DIRECT_LIGHT, 64), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_square() {
    all_hold(&square(1.0), 51, &[(PURE_MC, 256), (DIRECT_LIGHT, 96), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_small_square() {
    all_hold(&square(0.5), 52, &[(PURE_MC, 1000), (DIRECT_LIGHT, 64), REST[0], REST[1], REST[2]]);
}

#[test]
fn a5_square_in_a_wide_view() {
    let methods = [(PARTICLE, 1250), (BDPT, 400), (BDPT_BALANCE, 400), (COMBINED, 400)];
    all_hold(&square_wide(), 53, &methods);
}

#[test]
fn a8_phong() {
    let methods = [(PURE_MC, 320), (DIRECT_LIGHT, 128), REST[0], REST[1], REST[2]];
    all_hold(&phong_disk(10.0, 0.5), 81, &methods);
    all_hold(&phong_disk(1e3, 0.05), 82, &methods);
    all_hold(&phong_disk(1e6, 0.002), 83, &methods);
}

#[test]
fn a8_max_phong() {
    let methods = [(PURE_MC, 128), (DIRECT_LIGHT, 128), REST[0], REST[1], REST[2]];
    all_hold(&max_phong_disk(10.0, 0.5), 84, &methods);
    all_hold(&max_phong_disk(1e3, 0.05), 85, &methods);
    all_hold(&max_phong_disk(1e6, 0.002), 86, &methods);
}
