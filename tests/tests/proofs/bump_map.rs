//! F12: a bump map on a glossy plate. It tilts the shading normal alone, so a method that
//! walks from the light must carry the other cosines than one that walks from the
//! camera; one that does not makes another picture.

use std::f32::consts::TAU;
use std::sync::Arc;
use traylib_geometry::Vec3;
use traylib_known::stage::{Stage, camera_of_size, floor, lambert, phong, rectangle};
use traylib_materials::{Bump, Layer, Maps, Material, Texture};
use traylib_math::{Grid, Rgb};
use traylib_scene::Scene;
use traylib_tests::agreement::{Budget, Other, Subject, agree};
use traylib_tests::findings::settle;
use traylib_tests::methods::{BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// Height of the hills over a side of the plate: with four hills to a side the
/// steepest slope is 2π·4·`HEIGHT`/2 = 1 along each axis.
const HEIGHT: f32 = 1.0 / (4.0 * TAU / 2.0);

/// Hills and hollows, four of each to a side: (1 + sin·sin)/2.
fn hills() -> Bump {
    const SIZE: usize = 64;
    let wave = |i: usize| (4.0 * TAU * (i as f32 + 0.5) / SIZE as f32).sin();
    let heights = (0..SIZE * SIZE).map(|i| 0.5 + 0.5 * wave(i % SIZE) * wave(i / SIZE));
    let pixels = Grid::from_values(SIZE, SIZE, heights.map(Rgb::splat).collect()).unwrap();
    let texture = Texture::new(pixels).unwrap();
    Bump { layer: Layer::new(Arc::new(texture)), height: HEIGHT }
}

/// A plate of 2 × 2 m under a square lamp, on a floor that it throws light on.
fn bumpy_plate() -> Scene {
    let view = camera_of_size(Vec3::new(0.0, -2.6, 1.6), Vec3::new(0.0, 0.0, 0.3), 45.0, [48, 36]);
    let maps = Maps { bump: Some(hills()), ..Maps::default() };
    let bumped = Material { maps: Some(Box::new(maps)), ..phong(0.4, 0.4, 20.0).into() };
    let plate = rectangle(Vec3::new(-1.0, -1.0, 0.3), 2.0 * Vec3::X, 2.0 * Vec3::Y);
    let lamp = rectangle(Vec3::new(-0.5, -0.2, 1.5), 0.8 * Vec3::Y, 0.8 * Vec3::X);
    Stage::new(view)
        .surface(floor(), lambert(0.5))
        .surface(plate, bumped)
        .light(lamp, 5.0, lambert(0.3))
        .build()
}

/// `walks` passes of `puremc`, the noisiest, go with one of `bdpt`.
fn bump_map_agrees(looks: &[u32], walks: u32, promise: f64) {
    let scene = bumpy_plate();
    let other = |method, passes| Other { method, passes, promise };
    let others = [
        other(COMBINED, 4),
        other(DIRECT_LIGHT, 4),
        other(PURE_MC, walks),
        other(BDPT_BALANCE, 1),
        other(PARTICLE, 4),
    ];
    let budget = Budget { tile: 12, looks: looks.to_vec() };
    settle(&agree(&Subject { name: "bump map", scene: &scene }, &others, &budget).findings);
}

#[test]
fn a_bump_map_is_the_same_from_the_light_and_from_the_camera() {
    bump_map_agrees(&[96], 12, 0.04);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn a_bump_map_is_the_same_at_length() {
    bump_map_agrees(&[128, 512, 2048], 32, 5e-3);
}
