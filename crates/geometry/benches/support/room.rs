//! A furnished room, as fine as one likes.

use super::surfaces::Surfaces;
use std::f32::consts::TAU;
use traylib_geometry::{Error, Mesh, Vec3};

/// A closed room of 6 × 3 × 5 metres, y up, with furniture of boxes, which are the
/// same at any fineness, and bent objects, whose triangles grow finer: large and
/// small ones side by side, as rooms have them.
#[derive(Debug)]
pub(crate) struct Room {
    pub(crate) name: &'static str,
    pub(crate) mesh: Mesh,
}

/// The position of the camera, and below it the point that it looks at.
pub(crate) const EYE: Vec3 = Vec3::new(0.5, 1.7, 4.6);
pub(crate) const TARGET: Vec3 = Vec3::new(3.4, 0.8, 1.8);

/// A lamp below the ceiling that shadow rays aim at and that blocks none: a corner
/// and the edges from there.
pub(crate) const LAMP: [Vec3; 3] =
    [Vec3::new(2.2, 2.8, 1.9), Vec3::new(1.6, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.2)];

const SIZE: Vec3 = Vec3::new(6.0, 3.0, 5.0);

impl Room {
    /// About a thousand triangles.
    pub(crate) fn small() -> Result<Self, Error> {
        Self::new("small", 1)
    }

    /// About sixty thousand triangles.
    pub(crate) fn medium() -> Result<Self, Error> {
        Self::new("medium", 13)
    }

    /// About a million triangles.
    pub(crate) fn large() -> Result<Self, Error> {
        Self::new("large", 50)
    }

    fn new(name: &'static str, fineness: u32) -> Result<Self, Error> {
        let mut surfaces = Surfaces::default();
        walls(&mut surfaces, fineness);
        table(&mut surfaces);
        for seat in 0..4 {
            chair(&mut surfaces, Vec3::new(2.2 + 1.1 * (seat % 2) as f32, 0.0, side(seat)));
        }
        shelf(&mut surfaces);
        rods(&mut surfaces);
        textiles(&mut surfaces, fineness);
        pottery(&mut surfaces, fineness);
        Ok(Self { name, mesh: surfaces.mesh()? })
    }
}

fn side(seat: i32) -> f32 {
    if seat < 2 { 1.0 } else { 2.7 }
}

/// Floor, ceiling and four walls in rough plaster. Their rims are flat, so they meet.
fn walls(surfaces: &mut Surfaces, fineness: u32) {
    let rough = |u: f32, v: f32| {
        let rim = 16.0 * u * (1.0 - u) * v * (1.0 - v);
        0.01 * rim * (31.0 * u).sin() * (43.0 * v).cos()
    };
    for axis in 0..3 {
        let [along_u, along_v] = [Vec3::AXES[(axis + 1) % 3], Vec3::AXES[(axis + 2) % 3]];
        for end in [0.0, 1.0] {
            surfaces.sheet([fineness, fineness], |u, v| {
                let depth = Vec3::AXES[axis] * (end * SIZE + rough(u, v));
                depth + SIZE * (u * along_u + v * along_v)
            });
        }
    }
}

fn table(surfaces: &mut Surfaces) {
    surfaces.cuboid(Vec3::new(1.9, 0.72, 1.3), Vec3::new(3.9, 0.76, 2.5));
    legs(surfaces, Vec3::new(1.95, 0.0, 1.35), Vec3::new(1.84, 0.72, 1.04), 0.06);
}

fn chair(surfaces: &mut Surfaces, place: Vec3) {
    let part = |low: [f32; 3], high: [f32; 3]| (place + Vec3::from(low), place + Vec3::from(high));
    for (low, high) in
        [part([0.0, 0.42, 0.0], [0.45, 0.46, 0.45]), part([0.0, 0.46, 0.0], [0.45, 0.95, 0.03])]
    {
        surfaces.cuboid(low, high);
    }
    legs(surfaces, place, Vec3::new(0.41, 0.42, 0.41), 0.04);
}

/// Four legs below a rectangle of `size`, which `corner` stands in.
fn legs(surfaces: &mut Surfaces, corner: Vec3, size: Vec3, thickness: f32) {
    for (x, z) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
        let low = corner + Vec3::new(x * size.x, 0.0, z * size.z);
        surfaces.cuboid(low, low + Vec3::new(thickness, size.y, thickness));
    }
}

/// Five boards between two sides, books of all heights on four.
fn shelf(surfaces: &mut Surfaces) {
    let upright = Vec3::new(0.03, 2.2, 0.3);
    for x in [4.0, 5.6] {
        let low = Vec3::new(x, 0.0, 0.05);
        surfaces.cuboid(low, low + upright);
    }
    for board in 0..5 {
        let low = Vec3::new(4.03, 0.1 + 0.5 * board as f32, 0.05);
        surfaces.cuboid(low, low + Vec3::new(1.57, 0.03, 0.3));
        for book in 0..if board < 4 { 6 } else { 0 } {
            let size = Vec3::new(0.05 + 0.03 * wave(book), 0.25 + 0.15 * wave(book + board), 0.2);
            let low = low + Vec3::new(0.1 + 0.2 * book as f32, 0.03, 0.0);
            surfaces.cuboid(low, low + size);
        }
    }
}

/// Some number in [0, 1] for each integer.
fn wave(i: i32) -> f32 {
    0.5 + 0.5 * (2.4 * i as f32).sin()
}

/// Slanted sticks, three flat sides each: long and thin triangles in large boxes.
fn rods(surfaces: &mut Surfaces) {
    for rod in 0..8 {
        let foot = Vec3::new(0.3 + 0.08 * rod as f32, 0.0, 0.4);
        let top = foot + Vec3::new(0.6 * wave(rod), 2.4, 0.5 * wave(rod + 3));
        surfaces.ring([3, 1], |u, v| {
            foot.lerp(top, v) + 0.012 * Vec3::new((TAU * u).cos(), 0.0, (TAU * u).sin())
        });
    }
}

/// A carpet and a curtain, in folds.
fn textiles(surfaces: &mut Surfaces, fineness: u32) {
    surfaces.sheet([8 * fineness, 4 * fineness], |u, v| {
        let pile = 0.004 * ((90.0 * u).sin() * (70.0 * v).sin() + 1.5);
        Vec3::new(1.2 + 3.4 * u, 0.02 + pile, 0.9 + 2.2 * v)
    });
    surfaces.sheet([8 * fineness, 4 * fineness], |u, v| {
        let fold = 0.06 * (40.0 * u).sin() * (1.0 - 0.5 * v);
        Vec3::new(5.8 + fold, 0.1 + 2.7 * v, 1.4 + 2.8 * u)
    });
}

/// Three vases and a ball on the table, a lampshade above it.
fn pottery(surfaces: &mut Surfaces, fineness: u32) {
    let cells = [6 * fineness, 4 * fineness];
    for vase in 0..3 {
        let place = Vec3::new(2.2 + 0.45 * vase as f32, 0.76, 1.6 + 0.5 * wave(vase));
        turned(surfaces, cells, place, 0.35, |v| 0.06 + 0.05 * (5.0 * v + vase as f32).sin());
    }
    let ball = Vec3::new(3.45, 0.76, 2.1);
    turned(surfaces, cells, ball, 0.3, |v| (v * (1.0 - v)).max(0.0).sqrt() * 0.3);
    let shade = Vec3::new(2.9, 2.0, 1.9);
    turned(surfaces, [6 * fineness, 2 * fineness], shade, 0.3, |v| 0.35 - 0.2 * v);
}

/// A surface turned on a lathe: `radius` at each part of its height above `foot`.
fn turned(
    surfaces: &mut Surfaces,
    cells: [u32; 2],
    foot: Vec3,
    height: f32,
    radius: impl Fn(f32) -> f32,
) {
    surfaces.ring(cells, |u, v| {
        let (sin, cos) = (TAU * u).sin_cos();
        foot + Vec3::new(radius(v) * cos, height * v, radius(v) * sin)
    });
}
