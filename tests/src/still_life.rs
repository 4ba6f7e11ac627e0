//! A small scene with one of everything.

use traylib_geometry::{Mesh, Vec3};
use traylib_known::stage::{
    Stage, ball, black, camera_of_size, hollow_cube, lambert, mirror, phong, rectangle,
};
use traylib_scene::Scene;

/// A diffuse room with a ball for a lamp, a point light, a mirror on the wall, a
/// glossy ball and a rounded octahedron, 40 × 30 pixels.
///
/// All lengths are multiplied by `scale` and the point light's intensity by its
/// square, which leaves every radiance as it was.
pub fn still_life(scale: f32) -> Scene {
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z) * scale;
    let camera = camera_of_size(at(0.1, 0.2, 1.9), at(0.0, -0.3, -1.0), 60.0, [40, 30]);
    let room = hollow_cube(2.0 * scale)
        .into_iter()
        .fold(Stage::new(camera), |stage, side| stage.surface(side, lambert(0.6)));
    let on_the_wall = rectangle(at(-1.6, -1.0, -1.9), at(1.4, 0.0, 0.2), at(0.0, 2.1, 0.1));
    room.surface(on_the_wall, mirror(0.9, 0.0))
        .surface(ball(at(0.7, -1.3, -0.4), 0.7 * scale), phong(0.3, 0.6, 30.0))
        .mesh(octahedron(at(-0.7, -1.3, 0.1), 0.6 * scale), lambert(0.7))
        .light(ball(at(0.8, 1.2, -0.3), 0.35 * scale), 6.0, black())
        .point(at(-1.1, 1.3, 0.7), 2.0 * scale * scale)
        .build()
}

/// Eight triangles with the normals of the ball around them.
fn octahedron(centre: Vec3, radius: f32) -> Mesh {
    let normals = vec![Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
    let positions = normals.iter().map(|&normal| centre + radius * normal).collect();
    let triangles = vec![
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    Mesh::new(positions, triangles)
        .and_then(|mesh| mesh.with_normals(normals))
        .expect("a sound octahedron")
}
