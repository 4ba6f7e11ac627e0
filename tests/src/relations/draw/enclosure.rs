//! Spaces: rooms, floors, skies.

use super::{Dice, material, number, shape};
use crate::relations::scene::sides_of_box;
use crate::relations::scene::{Material, Mesh, Object, Shape};
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// A block of space that objects are put into.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosure {
    pub(super) min: Vec3,
    pub(super) max: Vec3,
}

impl Enclosure {
    pub(super) fn around_origin(half: f32) -> Self {
        Self { min: Vec3::splat(-half), max: Vec3::splat(half) }
    }

    pub(super) fn extent(&self) -> Vec3 {
        self.max - self.min
    }

    pub(super) fn centre(&self) -> Vec3 {
        0.5 * (self.min + self.max)
    }

    /// Its shortest side.
    pub(super) fn size(&self) -> f32 {
        self.extent().min_element()
    }

    /// A point of it, not at its walls.
    pub(super) fn place(&self, dice: &mut Dice) -> Vec3 {
        let (low, high) = (self.min + 0.15 * self.extent(), self.max - 0.15 * self.extent());
        Vec3::from_array([0, 1, 2].map(|axis| number::between(dice, low[axis], high[axis])))
    }
}

/// About as large as rooms are, the floor rather at height zero.
pub(super) fn extent(dice: &mut Dice) -> Enclosure {
    let size = Vec3::from_array([0; 3].map(|_| number::between(dice, 1.5, 5.0)));
    let corner = match dice.below(4) {
        0 => Vec3::ZERO,
        1 => Vec3::new(-0.5 * size.x, 0.0, -0.5 * size.z),
        2 => -0.5 * size,
        _ => Vec3::from_array([0; 3].map(|_| number::between(dice, -3.0, 3.0))),
    };
    Enclosure { min: corner, max: corner + size }
}

/// Closed all around, seen from within.
pub(super) fn walls(dice: &mut Dice, space: &Enclosure) -> Vec<Object> {
    let block = Shape::Box([space.min, space.max]);
    let plain = |material: Material, shape: Shape, sides: Sides| Object {
        shape,
        material,
        emission: Vec3::ZERO,
        sides,
    };
    let sides = if dice.chance(0.2) { Sides::Front } else { Sides::Both };
    match dice.below(6) {
        0 => vec![plain(material::wall(dice), block, Sides::Both)],
        1 => {
            let radius = 0.5 * space.extent().length();
            let shape = Shape::Sphere { centre: space.centre(), radius, inward: true };
            vec![plain(material::wall(dice), shape, sides)]
        }
        2 => vec![plain(material::wall(dice), inward_mesh(space), sides)],
        _ => {
            let as_triangles = dice.chance(0.3);
            let mut walls = Vec::new();
            for side in sides_of_box(&block) {
                let Shape::Quad([corner, u, v]) = side else { continue };
                let material = material::wall(dice);
                if as_triangles {
                    let [a, b, c, d] = [corner, corner + v, corner + u + v, corner + u];
                    for half in [[a, b, c], [a, c, d]] {
                        walls.push(plain(material.clone(), Shape::Triangle(half), sides));
                    }
                } else {
                    walls.push(plain(material, Shape::Quad([corner, v, u]), sides));
                }
            }
            walls
        }
    }
}

/// Twelve triangles that share eight corners, their fronts inside.
fn inward_mesh(space: &Enclosure) -> Shape {
    let corner = |i: u32| {
        let pick = |axis: u32| if i >> axis & 1 == 1 { space.max } else { space.min };
        Vec3::new(pick(0).x, pick(1).y, pick(2).z)
    };
    let quads: [[u32; 4]; 6] =
        [[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]];
    // Each is counter-clockwise seen from outside; turned round it faces inward.
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, c, b], [a, d, c]]);
    let mesh = Mesh::flat((0..8).map(corner).collect(), triangles.collect());
    Shape::Mesh(face_inward(mesh, space.centre()))
}

fn face_inward(mut mesh: Mesh, centre: Vec3) -> Mesh {
    let corners: Vec<[Vec3; 3]> = mesh.corners().collect();
    for (triangle, [a, b, c]) in mesh.triangles.iter_mut().zip(corners) {
        if (b - a).cross(c - a).dot(centre - a) < 0.0 {
            triangle.swap(1, 2);
        }
    }
    mesh
}

/// A ball or a box that shines inward.
pub(super) fn sky(dice: &mut Dice, space: &Enclosure) -> Object {
    let radius = space.extent().length() * dice.pick(&[0.75, 2.0, 10.0]);
    let radius = if dice.chance(0.5) { radius.ceil() } else { radius };
    let reflectance = if dice.chance(0.8) { 0.0 } else { 0.5 };
    Object {
        shape: Shape::Sphere { centre: space.centre(), radius, inward: true },
        material: Material::grey(reflectance),
        emission: Vec3::ONE,
        sides: if dice.chance(0.1) { Sides::Front } else { Sides::Both },
    }
}

/// Flat, at the bottom of a space.
pub(super) fn floor(dice: &mut Dice, space: &Enclosure) -> Object {
    let middle = space.centre() * Vec3::new(1.0, 0.0, 1.0) + Vec3::Y * space.min.y;
    let size = space.extent().max_element() * dice.pick(&[0.5, 1.0, 3.0]);
    let shape = shape::flat_facing(dice, middle, Vec3::Y, size);
    Object {
        material: material::any(dice, &shape),
        shape,
        emission: Vec3::ZERO,
        sides: Sides::Both,
    }
}
