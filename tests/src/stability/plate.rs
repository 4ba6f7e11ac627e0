//! F12: a flat plate whose vertex normals tilt like those of a bumpy one.
//!
//! Light that comes to it from a lamp and light that goes from it to the camera
//! carry different cosines, of N_s and of N_g; techniques agree only if each
//! walk knows which it is on.

use traylib_geometry::{Mesh, Vec3};
use traylib_known::stage::{Stage, black, camera, phong, rectangle};
use traylib_scene::Scene;

/// Squares along an edge.
const SQUARES: u32 = 12;

/// F12: under a square lamp of the same size, half a metre above; the camera looks
/// through its back, which is not there.
pub fn under_lamp() -> Scene {
    // y × x points down.
    let lamp = rectangle(Vec3::new(-1.0, -1.0, 0.5), 2.0 * Vec3::Y, 2.0 * Vec3::X);
    plate().light(lamp, 1.0, black()).build()
}

/// F12p: under a point light, for `trace`.
pub fn under_point() -> Scene {
    plate().point(Vec3::new(0.0, 0.3, 1.4), 2.0).build()
}

fn plate() -> Stage {
    let camera = camera(Vec3::new(0.0, -1.2, 1.8), Vec3::new(0.0, -0.1, 0.0), 50.0, 32);
    Stage::new(camera).mesh(bumpy(), phong(0.4, 0.4, 20.0))
}

/// The square |x|, |y| ≤ 1 of the plane z = 0 with the normals of a height field
/// whose slope reaches one.
fn bumpy() -> Mesh {
    let corners = SQUARES + 1;
    let at = |i: u32| 2.0 * i as f32 / SQUARES as f32 - 1.0;
    let positions: Vec<Vec3> =
        (0..corners * corners).map(|i| Vec3::new(at(i % corners), at(i / corners), 0.0)).collect();
    let slope = |x: f32, y: f32| (7.0 * x + 2.0 * y).sin() * (5.0 * y - x).cos();
    let normal = |p: &Vec3| Vec3::new(-slope(p.x, p.y), -slope(p.y, p.x) * 0.7, 1.0);
    let normals = positions.iter().map(normal).collect();
    let square = |i: u32| {
        let a = i / SQUARES * corners + i % SQUARES;
        [[a, a + 1, a + corners + 1], [a, a + corners + 1, a + corners]]
    };
    let triangles = (0..SQUARES * SQUARES).flat_map(square).collect();
    Mesh::new(positions, triangles)
        .and_then(|mesh| mesh.with_normals(normals))
        .expect("a sound plate")
}
