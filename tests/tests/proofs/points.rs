//! Quasi-random points against closed forms: they change how soon a mean is known, not the
//! mean. Of the family of `analytic.rs`.

use traylib_integrators::Method;
use traylib_known::Case;
use traylib_known::analytic::{disk, square_wide};
use traylib_known::furnace::{diffuse_walls, glowing_cube, offset_light_wide};
use traylib_tests::findings::settle;
use traylib_tests::measure::compare_by_points;
use traylib_tests::methods::{BDPT, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

fn all_hold(case: &Case, seed: u64, methods: &[(Method, u32)]) {
    let compare = |&(method, passes): &(Method, u32)| compare_by_points(case, method, passes, seed);
    settle(&methods.iter().map(compare).collect::<Vec<_>>());
}

/// One choice of everything, of a lamp alone.
#[test]
fn points_on_a_disk() {
    all_hold(&disk(1.0), 401, &[(PURE_MC, 400), (DIRECT_LIGHT, 128), (COMBINED, 128), (BDPT, 128)]);
}

/// Light paths, which number themselves through.
#[test]
fn points_by_way_of_splats() {
    all_hold(&square_wide(), 402, &[(PARTICLE, 1800), (BDPT, 900)]);
    all_hold(&offset_light_wide(None), 403, &[(PARTICLE, 1000), (BDPT, 100)]);
}

/// Long paths of many dimensions, under six lamps.
#[test]
fn points_in_a_furnace() {
    let methods = [(PURE_MC, 384), (COMBINED, 384), (BDPT, 192), (PARTICLE, 1000)];
    all_hold(&glowing_cube(diffuse_walls(), None), 404, &methods);
}
