//! D2 to D11: geometry that hurts, where the answer is known all the same.

use crate::analytic::{from_aside, lit_floor};
use crate::case::Case;
use crate::frame::frame;
use crate::stage::{
    Stage, black, camera, disk, disk_facing_down, floor, hollow_cube_at, lambert, rectangle, sound,
    spot,
};
use glam::DVec3;
use std::f64::consts::PI;
use traylib_geometry::{Mesh, Primitive, Vec3};
use traylib_scene::Scene;

/// D3: a disk of radius 1 so close above a floor with this normal, 2 m square,
/// seen through its back, which is not there: F = 1/(1 + h²), A2 upside down.
///
/// A ray leaves the floor as far off as rounding can have moved the hit: not at
/// all from z = 0, up to some 2·10⁻⁶ m from a floor of this size that leans.
pub fn close_light(normal: DVec3, height: f64) -> Case {
    let [axis, u, v] = frame(normal);
    let corner = (u + v) * -1.0;
    let patch = rectangle(corner.as_vec3(), (u * 2.0).as_vec3(), (v * 2.0).as_vec3());
    let lamp = disk((axis * height).as_vec3(), (axis * -1.0).as_vec3(), 1.0);
    let eye = spot((axis * 2.0 + u * 0.3).as_vec3(), Vec3::ZERO);
    let scene = Stage::new(eye).surface(patch, lambert(0.5)).light(lamp, 3.0, black()).build();
    let truth = 0.5 * 3.0 / (1.0 + height * height);
    Case {
        name: format!("D3 h = {height:e}, normal at {:.2} to z", axis.z),
        scene,
        max_depth: None,
        truth,
    }
}

/// D4: the floor under the disk of A2, R = 1, seen at an angle of 89.9° to its
/// normal from 0.2 m, where the spot is 2 mm long.
pub fn grazing_view() -> Case {
    let angle = 89.9_f64.to_radians();
    let toward_eye = Vec3::new(-angle.sin() as f32, 0.0, angle.cos() as f32);
    let lamp = disk_facing_down(Vec3::Z, 1.0);
    lit_floor("D4".into(), spot(0.2 * toward_eye, Vec3::ZERO), &[lamp], 0.5)
}

/// D5: a point light at the distance 1, in a direction of 89.9° to the normal:
/// E = I·cosθ, a 573rd of what straight light would give.
pub fn grazing_light() -> Case {
    let angle = 89.9_f64.to_radians();
    let light = Vec3::new(angle.sin() as f32, 0.0, angle.cos() as f32);
    // What the light's rounded place gives, with I = 3 and ρ = 0.5.
    let distance = f64::from(light.length());
    let truth = 0.5 / PI * 3.0 * f64::from(light.z) / distance.powi(3);
    let scene = Stage::new(spot(Vec3::new(-0.6, 0.2, 0.5), Vec3::ZERO))
        .surface(floor(), lambert(0.5))
        .point(light, 3.0)
        .build();
    Case { name: "D5".into(), scene, max_depth: None, truth }
}

/// D8: a disk of radius r straight above at the height 1, of an area 10⁻¹² of
/// the floor's 128² m²: F = r²/(1 + r²).
pub fn tiny_light() -> Case {
    let area = 1e-12 * 128.0 * 128.0;
    let radius = f64::sqrt(area / PI);
    let lamp = disk_facing_down(Vec3::Z, radius as f32);
    from_aside("D8".into(), &[lamp], radius * radius / (1.0 + radius * radius))
}

/// A cube of half-side h and reflectance ρ = 0.5 with a point light of intensity
/// I = π·h² in the middle, from where one wall is seen. By symmetry all walls
/// have the mean of B7: L = ρ/π·4πI/(24h²·(1 − ρ)) = π/6.
pub fn lit_cube(name: String, centre: Vec3, half: f32) -> Case {
    let eye = camera(centre, centre + half * Vec3::X, 90.0, 32);
    let scene = hollow_cube_at(centre, half)
        .into_iter()
        .fold(Stage::new(eye), |stage, side| stage.surface(side, lambert(0.5)))
        .point(centre, PI as f32 * half * half)
        .build();
    Case { name, scene, max_depth: None, truth: PI / 6.0 }
}

/// D6: the cube of [`lit_cube`] with h = 1, its walls made of a fan of triangles
/// among which there are slivers a millionth as wide as long, all of them
/// twice, and some without any area.
pub fn cube_of_slivers() -> Case {
    let eye = camera(Vec3::ZERO, Vec3::X, 90.0, 32);
    let scene = hollow_cube_at(Vec3::ZERO, 1.0)
        .into_iter()
        .fold(Stage::new(eye), |stage, side| stage.mesh(fan(&side), lambert(0.5)))
        .point(Vec3::ZERO, PI as f32)
        .build();
    Case { name: "D6".into(), scene, max_depth: None, truth: PI / 6.0 }
}

/// The triangles between a corner of a side and points along the edges that are
/// opposite to it.
fn fan(side: &Primitive) -> Mesh {
    const SLIVER: f32 = 1e-6;
    let Primitive::Quad(quad) = side else { unreachable!("a side of a cube") };
    let [u, v] = quad.edges();
    let along = [0.0, SLIVER, 0.3, 0.5, 0.5 + SLIVER, 0.8, 1.0];
    let up = along.map(|part| quad.corner() + u + part * v);
    let back = along.map(|part| quad.corner() + v + (1.0 - part) * u);
    let positions = [&[quad.corner()], &up[..], &back[..]].concat();
    let last = positions.len() as u32 - 1;
    let once: Vec<[u32; 3]> = (1..last).map(|i| [0, i, i + 1]).collect();
    let without_area = [[0, 1, 1], [2, 2, 2]];
    let triangles = [&once[..], &without_area, &once].concat();
    sound(Mesh::new(positions, triangles))
}

/// D7: a plate whose vertex normals lean by up to a slope of 5, this way and
/// that, under a square lamp.
pub fn bumpy_plate() -> Scene {
    const SIDE: u32 = 9;
    let corners = || (0..SIDE * SIDE).map(|i| (i % SIDE, i / SIDE));
    let place = |i: u32| 2.0 * i as f32 / (SIDE - 1) as f32 - 1.0;
    let positions = corners().map(|(x, y)| Vec3::new(place(x), place(y), 0.0)).collect();
    let slope = |i: u32| [0.0, 5.0, 0.0, -5.0][i as usize % 4];
    let normals = corners().map(|(x, y)| Vec3::new(slope(x), slope(y + 1), 1.0)).collect();
    let triangles = corners()
        .filter(|&(x, y)| x + 1 < SIDE && y + 1 < SIDE)
        .map(|(x, y)| y * SIDE + x)
        .flat_map(|i| [[i, i + 1, i + SIDE], [i + 1, i + SIDE + 1, i + SIDE]])
        .collect();
    let mesh = Mesh::new(positions, triangles).and_then(|mesh| mesh.with_normals(normals));
    // y × x points down.
    let lamp = rectangle(Vec3::new(-0.5, -0.5, 1.5), Vec3::Y, Vec3::X);
    Stage::new(camera(Vec3::new(0.2, -1.5, 1.2), Vec3::ZERO, 50.0, 32))
        .mesh(sound(mesh), lambert(0.8))
        .light(lamp, 3.0, black())
        .build()
}
