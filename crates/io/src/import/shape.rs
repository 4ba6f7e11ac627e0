//! Shapes: from documents to primitives.

use super::place::Place;
use crate::report::Problems;
use crate::ron_scene::{self, Block, Cone, Disk, Facing, Quad, Shape, Sphere, Triangle};
use traylib_geometry::{self as geometry, Error, Primitive};
use traylib_math::Vec3;

/// The primitives of a shape that needs no file; none of one that makes no sense.
pub(super) fn primitives(shape: &Shape, place: &Place, problems: &mut Problems) -> Vec<Primitive> {
    if !are_numbers(shape, place, problems) {
        return Vec::new();
    }
    let single = match shape {
        Shape::Quad(s) => geometry::Quad::new(s.corner.into(), s.edge_u.into(), s.edge_v.into())
            .map(Primitive::Quad),
        Shape::Sphere(s) => geometry::Sphere::new(s.center.into(), s.radius, facing(s.facing))
            .map(Primitive::Sphere),
        Shape::Disk(s) => geometry::Disk::ring(s.center.into(), s.normal.into(), s.inner, s.radius)
            .map(Primitive::Disk),
        Shape::Cone(s) => geometry::Cone::new(s.ends.map(Vec3::from), s.radii, facing(s.facing))
            .map(Primitive::Cone),
        Shape::Triangle(s) => {
            geometry::Triangle::new(s.a.into(), s.b.into(), s.c.into()).map(Primitive::Triangle)
        }
        Shape::Box(block) => return box_of(block, place, problems),
        Shape::Mesh(_) => return Vec::new(),
    };
    match single {
        Ok(primitive) => vec![primitive],
        Err(error) => {
            let problem = faulty_part(place, error).problem(error);
            problems.push(problem.with_help_if_any(advice(shape, error)));
            Vec::new()
        }
    }
}

/// Refuses what is infinite or not a number, field by field.
fn are_numbers(shape: &Shape, place: &Place, problems: &mut Problems) -> bool {
    let mut all = true;
    let mut check = |field, values: &[f32]| {
        if !values.iter().all(|value| value.is_finite()) {
            all = false;
            let message = format!("`{field}` is infinite or not a number");
            problems.push(place.field(field).problem(message));
        }
    };
    match shape {
        Shape::Quad(Quad { corner, edge_u, edge_v }) => {
            check("corner", corner);
            check("edge_u", edge_u);
            check("edge_v", edge_v);
        }
        Shape::Sphere(Sphere { center, radius, facing: _ }) => {
            check("center", center);
            check("radius", &[*radius]);
        }
        Shape::Disk(Disk { center, normal, radius, inner }) => {
            check("center", center);
            check("normal", normal);
            check("radius", &[*radius]);
            check("inner", &[*inner]);
        }
        Shape::Cone(Cone { ends, radii, facing: _ }) => {
            check("ends", ends.as_flattened());
            check("radii", radii);
        }
        Shape::Triangle(Triangle { a, b, c }) => {
            check("a", a);
            check("b", b);
            check("c", c);
        }
        Shape::Box(Block { min, max }) => {
            check("min", min);
            check("max", max);
        }
        Shape::Mesh(_) => {}
    }
    all
}

/// The field that an error is about, where it is about one.
#[expect(clippy::wildcard_enum_match_arm, reason = "an open set; most errors are of no one field")]
fn faulty_part(place: &Place, error: Error) -> Place {
    match error {
        Error::NoRadius => place.field("radius"),
        Error::NoNormal => place.field("normal"),
        _ => place.clone(),
    }
}

fn advice(shape: &Shape, error: Error) -> Option<String> {
    let help = match (error, shape) {
        (Error::NoArea, Shape::Quad(_)) => "are `edge_u` and `edge_v` parallel, or one of them 0?",
        (Error::NoArea, Shape::Triangle(_)) => "are `a`, `b` and `c` in a line?",
        _ => return None,
    };
    Some(help.to_string())
}

fn box_of(block: &Block, place: &Place, problems: &mut Problems) -> Vec<Primitive> {
    let wrong = (0..3).find(|&axis| block.min[axis] >= block.max[axis]);
    if let Some(axis) = wrong {
        let name = ["x", "y", "z"][axis];
        let (min, max) = (block.min[axis], block.max[axis]);
        let message = "`min` must be less than `max` in x, y and z";
        let problem = place.field("max").labelled(message, format!("{name} is {min} to {max}"));
        problems.push(problem);
        return Vec::new();
    }
    place.note(sides_of_block(block), problems).unwrap_or_default()
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
fn sides_of_block(block: &Block) -> Result<Vec<Primitive>, Error> {
    let (min, max) = (Vec3::from(block.min), Vec3::from(block.max));
    let size = max - min;
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * size);
    // The corners where u and v are zero.
    let [right, top] = [min.with_x(max.x), min.with_y(max.y).with_z(max.z)];
    let [front, right_front] = [min.with_z(max.z), max.with_y(min.y)];
    [(min, z, y), (right_front, -z, y), (min, x, z), (top, x, -z), (right, -x, y), (front, x, y)]
        .into_iter()
        .map(|(corner, u, v)| geometry::Quad::new(corner, u, v).map(Primitive::Quad))
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
            let quads = sides.iter().filter_map(|side| {
                if let Primitive::Quad(quad) = side { Some(quad) } else { None }
            });
            let quad = { quads }.find(|quad| quad.normal() == normal).unwrap();
            let [u, v] = quad.edges();
            assert_eq!([quad.corner(), quad.corner() + u, quad.corner() + v], corners, "{normal}");
        }
    }
}
