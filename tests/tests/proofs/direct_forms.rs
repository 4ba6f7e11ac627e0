//! More direct light against closed forms: lamps cut by the horizon, polygons,
//! coincident lights, round lamps, and whole surfaces. The forms stand in
//! `traylib_known::{horizon, polygonal, tubes, exchange}`; the comparisons
//! belong to one family with those of `analytic.rs`.

use traylib_known::analytic::coincident_lights;
use traylib_known::exchange::{disks, opposite_sides};
use traylib_known::horizon::cut_sphere;
use traylib_known::polygonal::{standing, sunk_pentagon, tilted_triangle};
use traylib_known::tubes::cones_and_a_tube;
use traylib_tests::measure::all_hold;
use traylib_tests::methods::{self, BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

#[test]
fn a4_cut_sphere() {
    all_hold(&cut_sphere(2.0, 0.3), 41, &[(BDPT, 176)]);
    all_hold(&cut_sphere(1.1, 0.2), 44, &[(DIRECT_LIGHT, 340)]);
}

/// Light sampling wastes what it draws below the horizon: half of the ball, and
/// nearly all of it.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn a4_cut_sphere_by_all_methods() {
    all_hold(&cut_sphere(1.1, 0.2), 45, &[(PURE_MC, 900), (COMBINED, 340), (BDPT_BALANCE, 340)]);
    for (seed, cosine, passes) in [(46, 0.0, 560), (47, -0.3, 2400)] {
        let methods = [DIRECT_LIGHT, BDPT].map(|method| (method, passes));
        all_hold(&cut_sphere(2.0, cosine), seed, &methods);
    }
}

#[test]
fn a6_standing_rectangle() {
    all_hold(&standing(1.0, 1.0, 1.0), 61, &[(DIRECT_LIGHT, 112)]);
    all_hold(&standing(2.0, 1.0, 0.5), 62, &[(BDPT, 192)]);
}

/// Lamps of several triangles, which are drawn by how large and how near they are.
/// The nearest part of the pentagon is below the floor, which draws cannot know.
#[test]
fn a7_polygons() {
    all_hold(&tilted_triangle(), 71, &[(DIRECT_LIGHT, 64), (BDPT, 64)]);
    all_hold(&sunk_pentagon(), 72, &[(COMBINED, 192), (BDPT, 192)]);
}

/// No noise: whichever is drawn gives the same.
#[test]
fn a9_coincident_lights() {
    for count in [1, 4, 1000] {
        let methods = methods::from_camera(32);
        all_hold(&coincident_lights(count), 91, &methods);
    }
}

/// A lamp that is round has a chance from all sides.
#[test]
fn a10_cones_and_a_tube() {
    all_hold(&cones_and_a_tube(), 92, &[(DIRECT_LIGHT, 450), (COMBINED, 400), (BDPT, 400)]);
}

#[test]
fn whole_surfaces() {
    all_hold(&disks(1.0), 93, &[(BDPT, 320), (PARTICLE, 1450)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn whole_surfaces_by_all_methods() {
    let methods =
        [(PURE_MC, 6500), (COMBINED, 500), (BDPT, 500), (BDPT_BALANCE, 640), (PARTICLE, 5600)];
    all_hold(&disks(2.0), 94, &methods);
    all_hold(&opposite_sides(), 95, &methods);
}
