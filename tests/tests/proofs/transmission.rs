//! Light that goes through things, against what is known; the derivations stand in
//! `traylib_tests::known::transmission`. The comparisons belong to one family with
//! those of `analytic.rs`.

use traylib_tests::known::transmission::{
    clear_things_in_a_furnace, furnace_from_inside_of_glass, lamp_behind_a_pane,
    light_in_a_ball_of_glass,
};
use traylib_tests::measure::all_hold;
use traylib_tests::programs::Program::{
    BdptBalance, BdptPower, Combined, Particle, PureMc, Strict,
};

#[test]
fn e1_clear_things_in_a_furnace() {
    let programs = [(PureMc, 288), (Combined, 192), (BdptPower, 192), (BdptBalance, 192)];
    all_hold(&clear_things_in_a_furnace(), 511, &programs);
}

/// The walk out of the glass takes several reflections inside.
#[test]
fn e2_furnace_from_inside_of_glass() {
    let programs = [(PureMc, 480), (Combined, 320), (BdptPower, 192), (BdptBalance, 192)];
    all_hold(&furnace_from_inside_of_glass(), 512, &programs);
}

#[test]
fn e3_lamp_behind_a_pane() {
    let programs = [(Strict, 96), (Combined, 96), (BdptPower, 96), (BdptBalance, 128)];
    all_hold(&lamp_behind_a_pane(), 513, &programs);
}

/// The light is aimed at in vain, since every ray to it meets the glass: paths
/// from the light alone find it.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn e4_light_in_a_ball_of_glass() {
    let programs = [(BdptPower, 4000), (BdptBalance, 4000), (Particle, 5000)];
    all_hold(&light_in_a_ball_of_glass(), 514, &programs);
}
