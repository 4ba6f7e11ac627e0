//! Our skies against what Mitsuba 3.9.1 makes of the same pictures and places.

use super::*;
use traylib_scene::{Camera, CameraSettings, SceneBuilder};

/// Column c of row r is (10r + c, (3r + c²) mod 7, 1).
fn picture() -> Grid<Rgb> {
    Grid::from_fn(8, 4, |index| {
        let (c, r) = (index % 8, index / 8);
        Rgb::new((10 * r + c) as f32, ((3 * r + c * c) % 7) as f32, 1.0)
    })
}

/// What a scene under this sky sees in three directions, red and green.
fn seen(sky: SkyLight) -> [[f32; 2]; 3] {
    let camera = Camera::new(CameraSettings {
        position: traylib_math::Vec3::ZERO,
        target: traylib_math::Vec3::X,
        up: traylib_math::Vec3::Y,
        fov_degrees: 40.0,
        width: 1,
        height: 1,
    });
    let mut builder = SceneBuilder::new(camera.unwrap());
    builder.set_sky(sky.radiance, sky.turn_degrees).unwrap();
    let scene = builder.build().unwrap();
    [[0.36, 0.48, -0.8], [-0.6, -0.48, 0.64], [0.48, 0.8, 0.36]].map(|toward| {
        let light = scene.sky().unwrap().radiance(toward.into());
        assert!((light.b - 1.0).abs() < 1e-5);
        [light.r, light.g]
    })
}

/// Half a texel of ours is at most 0.06 off each way.
fn agree(place: DMat3, expected: [[f32; 2]; 3]) {
    for (seen, expected) in seen(sky(&picture(), place)).iter().zip(expected) {
        let off = seen.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 0.12, "{seen:?} {expected:?}");
    }
}

#[test]
fn pictures_lie_as_in_mitsuba() {
    let as_it_is = [[10.257, 3.098], [24.240, 1.935], [8.464, 2.277]];
    agree(DMat3::IDENTITY, as_it_is);
    let turn = |axis, degrees: f64| DMat3::from_axis_angle(axis, degrees.to_radians());
    agree(turn(DVec3::Y, 30.0), [[10.924, 3.663], [24.907, 2.577], [9.131, 3.811]]);
    agree(turn(DVec3::X, 90.0), [[24.174, 3.404], [13.009, 2.038], [11.671, 3.438]]);
    let tilted = turn(DVec3::Z, 20.0) * turn(DVec3::X, -50.0);
    agree(tilted, [[6.644, 2.614], [26.857, 3.156], [16.486, 2.214]]);
    let mirrored = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
    agree(mirrored, [[17.181, 3.098], [22.322, 1.935], [10.826, 2.277]]);
}

#[test]
fn what_is_turned_about_up_keeps_its_texels() {
    let large = Grid::from_fn(1024, 512, |index| Rgb::splat((index % 1024) as f32));
    let turned = sky(&large, DMat3::from_rotation_y(0.5));
    assert!((turned.turn_degrees - 180.0 - 0.5_f32.to_degrees()).abs() < 1e-4);
    for column in 0..1024 {
        assert_eq!(turned.radiance.get(column, 100).r, column as f32);
    }
    let one = sky(&Grid::filled(1, 1, Rgb::WHITE), DMat3::IDENTITY);
    assert!(one.radiance.values().iter().all(|&light| light == Rgb::WHITE));
    let tall = sky(&Grid::filled(1, 4096, Rgb::WHITE), DMat3::IDENTITY);
    assert_eq!((tall.radiance.width(), tall.radiance.height()), (1, 4096));
}
