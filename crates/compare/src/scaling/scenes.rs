//! Scenes of any size.

use super::Axis;
use traylib_geometry::{Mesh, Primitive};
use traylib_known::stage::{
    Stage, ball, camera, disk_facing_down, floor, hollow_cube, lambert, rectangle,
};
use traylib_math::Vec3;
use traylib_scene::{Camera, Scene};

/// Pixels of a side where pixels do not grow.
const SIDE: u32 = 64;

/// The scene in which an axis has this size.
///
/// # Errors
/// A mesh cannot have so many triangles.
pub(super) fn scene(axis: Axis, size: u64) -> Result<Scene, String> {
    match axis {
        Axis::Triangles => Ok(ground(size)?),
        Axis::Lamps => Ok(lamps(size)),
        Axis::PathLength => Ok(room()),
        Axis::Pixels => Ok(balls((size as f64).sqrt() as u32)),
        Axis::Threads => Ok(balls(4 * SIDE)),
    }
}

/// A view from above at a slant, of the square from −1 to 1.
fn view(side: u32) -> Camera {
    camera(Vec3::new(0.0, -2.0, 1.5), Vec3::ZERO, 60.0, side)
}

fn lamp() -> Primitive {
    rectangle(Vec3::new(-0.5, 0.5, 2.0), Vec3::X, Vec3::NEG_Y)
}

/// Rough ground of about so many triangles, under a lamp.
fn ground(triangles: u64) -> Result<Scene, String> {
    let cells = (triangles as f64 / 2.0).sqrt().round() as u32;
    let height =
        |x: f32, y: f32| 0.1 * (7.0 * x).sin() * (5.0 * y).cos() + 0.02 * (61.0 * x * y).sin();
    let corner = |i: u32| 2.0 * i as f32 / cells as f32 - 1.0;
    let corners = (0..=cells).flat_map(|row| (0..=cells).map(move |column| (column, row)));
    let positions = corners.map(|(column, row)| {
        let (x, y) = (corner(column), corner(row));
        Vec3::new(x, y, height(x, y))
    });
    let at = |column: u32, row: u32| row * (cells + 1) + column;
    let triangles = (0..cells).flat_map(|row| (0..cells).map(move |column| (column, row)));
    let triangles = triangles.flat_map(|(column, row)| {
        let [a, b] = [at(column, row), at(column + 1, row)];
        let [c, d] = [at(column + 1, row + 1), at(column, row + 1)];
        [[a, b, c], [a, c, d]]
    });
    let mesh = Mesh::new(positions.collect(), triangles.collect());
    let mesh = mesh.map_err(|error| error.to_string())?;
    Ok(Stage::new(view(SIDE)).mesh(mesh, lambert(0.7)).light(lamp(), 1.0, lambert(0.0)).build())
}

/// Returns a scene of so many lamps in a square above a floor, in rows, all together of the same
/// size.
fn lamps(count: u64) -> Scene {
    let rows = (count as f64).sqrt().ceil() as u64;
    let step = 2.0 / rows as f32;
    let stage = Stage::new(view(SIDE)).surface(floor(), lambert(0.7));
    let place = |i: u64| [i % rows, i / rows].map(|n| (n as f32 + 0.5) * step - 1.0);
    let lamps = (0..count).map(|i| {
        let [x, y] = place(i);
        disk_facing_down(Vec3::new(x, y, 1.0), 0.25 * step)
    });
    lamps.fold(stage, |stage, disk| stage.light(disk, 1.0, lambert(0.0))).build()
}

/// A closed room that reflects nine tenths.
fn room() -> Scene {
    let lamp = disk_facing_down(Vec3::new(0.0, 0.0, 0.9), 0.25);
    let view = camera(Vec3::new(0.0, -0.9, 0.0), Vec3::Y, 90.0, SIDE);
    let walls = hollow_cube(1.0).into_iter();
    let stage = walls.fold(Stage::new(view), |stage, wall| stage.surface(wall, lambert(0.9)));
    stage.light(lamp, 1.0, lambert(0.0)).build()
}

/// Balls on a floor under a lamp, in a square picture.
fn balls(side: u32) -> Scene {
    let places = [[-0.6, 0.2], [0.0, -0.3], [0.6, 0.3]];
    let stage = Stage::new(view(side)).surface(floor(), lambert(0.7));
    let balls = places.map(|[x, y]| ball(Vec3::new(x, y, 0.3), 0.3)).into_iter();
    let stage = balls.fold(stage, |stage, ball| stage.surface(ball, lambert(0.5)));
    stage.light(lamp(), 1.0, lambert(0.0)).build()
}
