//! Light that goes through surfaces, against what is known; the derivations stand in
//! `traylib_known::transmission`. The comparisons belong to one family with
//! those of `analytic.rs`.

use traylib_known::transmission::{
    clear_surfaces_in_a_furnace, furnace_from_inside_of_glass, light_behind_a_pane,
    light_in_a_ball_of_glass,
};
use traylib_tests::measure::all_hold;
use traylib_tests::methods::{BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

#[test]
fn e1_clear_surfaces_in_a_furnace() {
    let methods = [(PURE_MC, 288), (COMBINED, 192), (BDPT, 192), (BDPT_BALANCE, 192)];
    all_hold(&clear_surfaces_in_a_furnace(), 511, &methods);
}

/// The walk out of the glass takes several reflections inside.
#[test]
fn e2_furnace_from_inside_of_glass() {
    let methods = [(PURE_MC, 480), (COMBINED, 320), (BDPT, 192), (BDPT_BALANCE, 192)];
    all_hold(&furnace_from_inside_of_glass(), 512, &methods);
}

#[test]
fn e3_lamp_behind_a_pane() {
    let methods = [(DIRECT_LIGHT, 96), (COMBINED, 96), (BDPT, 96), (BDPT_BALANCE, 128)];
    all_hold(&light_behind_a_pane(), 513, &methods);
}

/// The light is aimed at in vain, since every ray to it meets the glass: paths
/// from the light alone find it.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn e4_light_in_a_ball_of_glass() {
    let methods = [(BDPT, 4000), (BDPT_BALANCE, 4000), (PARTICLE, 5000)];
    all_hold(&light_in_a_ball_of_glass(), 514, &methods);
}
