//! Closed rooms with known radiance, for all lengths of paths and for each; the
//! derivations stand in `traylib_known::furnace`. The comparisons belong to one
//! family with those of `analytic.rs`.

use traylib_integrators::Method;
use traylib_known::furnace::{
    central_light, diffuse_walls, glowing_ball, glowing_cube, mirroring_walls, offset_light,
    offset_light_wide,
};
use traylib_tests::measure::all_hold;
use traylib_tests::methods::{BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// Samples of 1024 pixels a pass: a million light paths for the particle tracer,
/// of which a sixth ends up in view.
const WIDE: [(Method, u32); 6] = [
    (PURE_MC, 192),
    (DIRECT_LIGHT, 192),
    (COMBINED, 192),
    (BDPT, 128),
    (BDPT_BALANCE, 128),
    (PARTICLE, 900),
];

/// Samples of 4096 pixels a pass.
const SPOT: [(Method, u32); 5] =
    [(PURE_MC, 96), (DIRECT_LIGHT, 96), (COMBINED, 96), (BDPT, 48), (BDPT_BALANCE, 48)];

/// All but one.
fn without(method: Method, methods: &[(Method, u32)]) -> Vec<(Method, u32)> {
    methods.iter().copied().filter(|&(other, _)| other != method).collect()
}

/// Methods for the cube: without the strict `directlight`. Two patches near an
/// edge of the room see each other with a kernel that grows as 1/d², which light
/// sampling by area does not follow. Such a sample has a tail index of 1.5 and no
/// variance, so its interval means nothing. In a ball the kernel is constant.
fn cube() -> Vec<(Method, u32)> {
    without(DIRECT_LIGHT, &WIDE)
}

#[test]
fn b1_glowing_ball() {
    all_hold(&glowing_ball(diffuse_walls(), None), 111, &WIDE);
}

#[test]
fn b1_glowing_ball_to_four_edges() {
    all_hold(&glowing_ball(diffuse_walls(), Some(4)), 112, &WIDE);
}

#[test]
fn b1_glowing_cube() {
    all_hold(&glowing_cube(diffuse_walls(), None), 113, &cube());
}

#[test]
fn b1_glowing_cube_to_four_edges() {
    all_hold(&glowing_cube(diffuse_walls(), Some(4)), 114, &cube());
}

/// Without the particle tracer, which cannot see what a mirror shows.
#[test]
fn b2_mirroring_ball() {
    let methods = without(PARTICLE, &WIDE);
    all_hold(&glowing_ball(mirroring_walls(), None), 121, &methods);
    all_hold(&glowing_ball(mirroring_walls(), Some(4)), 122, &methods);
}

#[test]
fn b2_mirroring_cube() {
    let methods = without(PARTICLE, &cube());
    all_hold(&glowing_cube(mirroring_walls(), None), 123, &methods);
    all_hold(&glowing_cube(mirroring_walls(), Some(4)), 124, &methods);
}

/// All light of the particle tracer comes by splats here: cv² = 2.
#[test]
fn b4_light_in_the_middle_of_a_ball() {
    let methods = [without(PARTICLE, &WIDE), vec![(PARTICLE, 2100)]].concat();
    all_hold(&central_light(None), 141, &methods);
    all_hold(&central_light(Some(5)), 142, &methods);
}

#[test]
fn b5_light_beside_the_middle_of_a_ball() {
    for (seed, degrees) in [(151, 0.0), (152, 60.0), (153, 90.0), (154, 180.0)] {
        all_hold(&offset_light(degrees, None), seed, &SPOT);
    }
}

#[test]
fn b5_light_beside_the_middle_to_five_edges() {
    for (seed, degrees) in [(155, 0.0), (156, 60.0), (157, 90.0), (158, 180.0)] {
        all_hold(&offset_light(degrees, Some(5)), seed, &SPOT);
    }
}

#[test]
fn b5_in_a_wide_view() {
    all_hold(&offset_light_wide(None), 159, &WIDE);
    all_hold(&offset_light_wide(Some(5)), 160, &WIDE);
}
