//! Shapes: from documents to primitives.

use crate::ron_scene::{self, Block, Facing, Shape};
use traylib_geometry::{self as geometry, Disk, Primitive, Quad, Sphere, Triangle};
use traylib_math::Vec3;

/// The primitives of a shape that needs no file.
pub(super) fn primitives(shape: &Shape) -> Result<Vec<Primitive>, String> {
    let single = match shape {
        Shape::Quad(s) => {
            Quad::new(s.corner.into(), s.edge_u.into(), s.edge_v.into()).map(Primitive::Quad)
        }
        Shape::Sphere(s) => {
            Sphere::new(s.center.into(), s.radius, facing(s.facing)).map(Primitive::Sphere)
        }
        Shape::Disk(s) => {
            Disk::new(s.center.into(), s.normal.into(), s.radius).map(Primitive::Disk)
        }
        Shape::Triangle(s) => {
            Triangle::new(s.a.into(), s.b.into(), s.c.into()).map(Primitive::Triangle)
        }
        Shape::Box(block) => return sides_of_block(block),
        Shape::Mesh(_) => return Ok(Vec::new()),
    };
    single.map(|primitive| vec![primitive]).map_err(|e| e.to_string())
}

fn facing(facing: Facing) -> geometry::Facing {
    match facing {
        Facing::Outward => geometry::Facing::Outward,
        Facing::Inward => geometry::Facing::Inward,
    }
}

impl From<ron_scene::Sides> for geometry::Sides {
    fn from(sides: ron_scene::Sides) -> Self {
        match sides {
            ron_scene::Sides::Both => Self::Both,
            ron_scene::Sides::Front => Self::Front,
        }
    }
}

/// Six rectangles whose fronts are outside. Seen from there, with y up, u goes to the
/// right and v up on the four walls. Top and bottom go on from the wall at the largest
/// z: u along x, v past the wall's upper edge, and toward its lower one.
fn sides_of_block(block: &Block) -> Result<Vec<Primitive>, String> {
    let (min, max) = (Vec3::from(block.min), Vec3::from(block.max));
    if !min.cmplt(max).all() {
        return Err("`min` must be less than `max` in x, y and z".to_string());
    }
    let size = max - min;
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * size);
    // The corners where u and v are zero.
    let [right, top] = [min.with_x(max.x), min.with_y(max.y).with_z(max.z)];
    let [front, right_front] = [min.with_z(max.z), max.with_y(min.y)];
    [(min, z, y), (right_front, -z, y), (min, x, z), (top, x, -z), (right, -x, y), (front, x, y)]
        .into_iter()
        .map(|(corner, u, v)| {
            Quad::new(corner, u, v).map(Primitive::Quad).map_err(|e| e.to_string())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_geometry::{Ray, Sides};

    #[test]
    fn a_block_is_closed_and_faces_outward() {
        let block = Block { min: [-1.0, 2.0, 0.5], max: [3.0, 3.0, 1.5] };
        let sides = sides_of_block(&block).unwrap();
        let area: f32 = sides.iter().map(Primitive::area).sum();
        assert!((area - 2.0 * (4.0 * 1.0 + 4.0 * 1.0 + 1.0 * 1.0)).abs() < 1e-5);
        let middle = Vec3::new(1.0, 2.5, 1.0);
        for direction in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z] {
            let ray = Ray::new(middle, direction);
            let hits = |seen| sides.iter().filter_map(|s| s.intersect(&ray, seen)).count();
            assert_eq!((hits(Sides::Both), hits(Sides::Front)), (1, 0), "{direction}");
        }
    }

    #[test]
    fn pictures_lie_on_each_side_of_a_block() {
        let block = Block { min: [-1.0, 2.0, 0.5], max: [3.0, 3.0, 1.5] };
        let sides = sides_of_block(&block).unwrap();
        // Where to look from, and where the bottom left, the bottom right and the top
        // left corner of the picture are seen.
        let (left, right, low, high) = (-1.0, 3.0, 2.0, 3.0);
        let (back, front) = (0.5, 1.5);
        let point = Vec3::new;
        for (normal, corners) in [
            (
                Vec3::Z,
                [point(left, low, front), point(right, low, front), point(left, high, front)],
            ),
            (
                Vec3::X,
                [point(right, low, front), point(right, low, back), point(right, high, front)],
            ),
            (
                Vec3::NEG_Z,
                [point(right, low, back), point(left, low, back), point(right, high, back)],
            ),
            (
                Vec3::NEG_X,
                [point(left, low, back), point(left, low, front), point(left, high, back)],
            ),
            (
                Vec3::Y,
                [point(left, high, front), point(right, high, front), point(left, high, back)],
            ),
            (
                Vec3::NEG_Y,
                [point(left, low, back), point(right, low, back), point(left, low, front)],
            ),
        ] {
            let quads = sides.iter().filter_map(|side| match side {
                Primitive::Quad(quad) => Some(quad),
                Primitive::Triangle(_)
                | Primitive::Sphere(_)
                | Primitive::Disk(_)
                | Primitive::Cone(_) => None,
            });
            let quad = { quads }.find(|quad| quad.normal() == normal).unwrap();
            let [u, v] = quad.edges();
            assert_eq!([quad.corner(), quad.corner() + u, quad.corner() + v], corners, "{normal}");
        }
    }

    #[test]
    fn a_block_inside_out_or_not_a_number_is_refused() {
        for min in [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [f32::NAN, 0.0, 0.0]] {
            assert!(sides_of_block(&Block { min, max: [1.0; 3] }).is_err(), "{min:?}");
        }
    }
}
