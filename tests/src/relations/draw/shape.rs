//! Shapes of any kind.

use super::{Dice, number};
use crate::relations::form::motion::Motion;
use crate::relations::scene::{Mesh, Shape};
use std::f32::consts::{PI, TAU};
use traylib_math::{Vec2, Vec3};

/// Any shape, about so large, around a place.
pub(super) fn any(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    match dice.below(12) {
        0..=3 => flat(dice, place, size),
        4 | 5 => ball(dice, place, size),
        6 | 7 => block(dice, place, size),
        8 | 9 => tube(dice, place, size),
        _ => mesh(dice, place, size),
    }
}

/// Flat, rather facing along an axis.
pub(super) fn flat(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    let normal = if dice.chance(0.7) { dice.axis() } else { dice.direction() };
    flat_facing(dice, place, normal, size)
}

/// Flat, its front along `normal`.
pub(super) fn flat_facing(dice: &mut Dice, place: Vec3, normal: Vec3, size: f32) -> Shape {
    let [u, v] = edges(dice, normal);
    match dice.below(6) {
        0 | 1 => {
            let aspect = dice.pick(&[1.0, 1.0, 0.5, 0.1]);
            let (u, v) = (u * 2.0 * size, v * 2.0 * size * aspect);
            let v = if dice.chance(0.15) { v + 0.4 * u } else { v };
            Shape::Quad([place - 0.5 * (u + v), u, v])
        }
        2 | 3 => {
            let (a, b, c) =
                (dice.between(0.5, 1.0), dice.between(0.5, 1.0), dice.between(-0.6, 0.6));
            Shape::Triangle([
                place - (u + v * a) * size,
                place + (u - v * b) * size,
                place + (u * c + v) * size,
            ])
        }
        4 => Shape::Disk { centre: place, normal, inner: 0.0, radius: size },
        _ => Shape::Disk {
            centre: place,
            normal,
            inner: size * dice.pick(&[0.25, 0.5, 0.9]),
            radius: size,
        },
    }
}

/// Two unit vectors across, the normal along their cross product; along axes if
/// the normal is, but for some.
pub(super) fn edges(dice: &mut Dice, normal: Vec3) -> [Vec3; 2] {
    let least = [Vec3::X, Vec3::Y, Vec3::Z]
        .into_iter()
        .min_by(|a, b| normal.dot(*a).abs().total_cmp(&normal.dot(*b).abs()))
        .unwrap_or(Vec3::X);
    let u = (least - normal * normal.dot(least)).normalize();
    let v = normal.cross(u);
    if dice.chance(0.2) {
        let (sine, cosine) = dice.between(0.0, TAU).sin_cos();
        return [u * cosine + v * sine, v * cosine - u * sine];
    }
    [u, v]
}

fn ball(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    Shape::Sphere { centre: place, radius: size, inward: dice.chance(0.1) }
}

fn block(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    let half = Vec3::from_array([0; 3].map(|_| number::size(dice, 0.3 * size, 1.2 * size)));
    Shape::Box([place - half, place + half])
}

/// A tube or a cone, rather along an axis.
pub(super) fn tube(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    let along = if dice.chance(0.7) { dice.axis() } else { dice.direction() };
    let radius = size * dice.pick(&[0.05, 0.2, 0.5, 1.0]);
    let other = dice.pick(&[radius, radius, 0.5 * radius, 0.0]);
    let half = along * size * dice.pick(&[0.2, 1.0, 1.5]);
    Shape::Cone {
        ends: [place - half, place + half],
        radii: [radius, other],
        inward: dice.chance(0.2),
    }
}

/// A pyramid, a folded strip, or a ball of triangles that is smooth or has
/// texture coordinates.
pub(super) fn mesh(dice: &mut Dice, place: Vec3, size: f32) -> Shape {
    match dice.below(3) {
        0 => Shape::Mesh(pyramid(place, size)),
        1 => Shape::Mesh(strip(dice, place, size)),
        _ => Shape::Mesh(globe(dice, place, size)),
    }
}

/// On four corners; closed.
fn pyramid(place: Vec3, size: f32) -> Mesh {
    let foot = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[x, z]| place + Vec3::new(x, 0.0, z) * size);
    let positions = foot.into_iter().chain([place + Vec3::Y * 1.5 * size]).collect();
    let triangles = vec![[0, 1, 2], [0, 2, 3], [1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]];
    Mesh::flat(positions, triangles)
}

/// Two rectangles that meet at an edge, with texture coordinates.
fn strip(dice: &mut Dice, place: Vec3, size: f32) -> Mesh {
    let normal = if dice.chance(0.7) { dice.axis() } else { dice.direction() };
    let [u, v] = edges(dice, normal).map(|edge| edge * size);
    let fold = normal * size * dice.pick(&[0.0, 0.5, 1.0]);
    let rows = [place - u, place, place + u + fold];
    let positions = rows.iter().flat_map(|&row| [row - v, row + v]).collect();
    let uvs =
        [0.0, 0.5, 1.0].iter().flat_map(|&u| [Vec2::new(u, 0.0), Vec2::new(u, 1.0)]).collect();
    let triangles = vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]];
    Mesh { positions, triangles, normals: None, uvs: Some(uvs) }
}

/// A coarse ball, with its normals or without.
fn globe(dice: &mut Dice, place: Vec3, size: f32) -> Mesh {
    let (around, rows) = (dice.pick(&[4_u32, 6]), 3_u32);
    let mut normals = vec![Vec3::Y];
    for row in 1..rows {
        let (sine, cosine) = (PI * row as f32 / rows as f32).sin_cos();
        for step in 0..around {
            let (s, c) = (TAU * step as f32 / around as f32).sin_cos();
            normals.push(Vec3::new(sine * c, cosine, sine * s));
        }
    }
    normals.push(Vec3::NEG_Y);
    let (last, at) =
        (normals.len() as u32 - 1, |row: u32, step: u32| 1 + row * around + step % around);
    let mut triangles = Vec::new();
    for step in 0..around {
        triangles.push([0, at(0, step + 1), at(0, step)]);
        triangles.push([last, at(rows - 2, step), at(rows - 2, step + 1)]);
        for row in 0..rows - 2 {
            let [a, b, c, d] =
                [at(row, step), at(row, step + 1), at(row + 1, step + 1), at(row + 1, step)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let positions = normals.iter().map(|normal| place + *normal * size).collect();
    Mesh { positions, triangles, normals: dice.chance(0.6).then_some(normals), uvs: None }
}

/// Moves a shape.
pub(super) fn moved(shape: &Shape, by: Vec3) -> Shape {
    Motion::shift(by.as_dvec3()).shape(shape)
}
