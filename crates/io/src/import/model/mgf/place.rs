//! MGF's shapes put elsewhere, and turned inside out.

use crate::import::placement::Placement;
use crate::mgf::{Shape, Vertex};

/// The shape where it goes.
pub(super) fn placed(shape: &Shape, placement: &Placement) -> Shape {
    let point = |p| placement.wide_point(p);
    let direction = |d| placement.wide_direction(d);
    let length = |l: f64| l * placement.scale();
    let loop_of = |vertices: &[Vertex]| {
        let placed =
            |v: &Vertex| Vertex { position: point(v.position), normal: v.normal.map(direction) };
        vertices.iter().map(placed).collect::<Vec<_>>()
    };
    match shape {
        Shape::Face { outline, holes } => Shape::Face {
            outline: loop_of(outline),
            holes: holes.iter().map(|hole| loop_of(hole)).collect(),
        },
        Shape::Sphere { centre, radius, inward } => {
            Shape::Sphere { centre: point(*centre), radius: length(*radius), inward: *inward }
        }
        Shape::Cylinder { ends, radius, inward } => {
            Shape::Cylinder { ends: ends.map(point), radius: length(*radius), inward: *inward }
        }
        Shape::Cone { ends, radii, inward } => {
            Shape::Cone { ends: ends.map(point), radii: radii.map(length), inward: *inward }
        }
        Shape::Ring { centre, normal, radii } => Shape::Ring {
            centre: point(*centre),
            normal: direction(*normal),
            radii: radii.map(length),
        },
        Shape::Torus { centre, normal, radius, tube_radius, inward } => Shape::Torus {
            centre: point(*centre),
            normal: direction(*normal),
            radius: length(*radius),
            tube_radius: length(*tube_radius),
            inward: *inward,
        },
        Shape::Prism { outline, offset, inward } => Shape::Prism {
            outline: loop_of(outline),
            offset: direction(*offset) * length(offset.length()),
            inward: *inward,
        },
    }
}

/// Turns a surface, so that its front is where its back was. Prisms stay: both of their
/// sides are never wanted.
pub(super) fn turned(shape: &Shape) -> Shape {
    let mut shape = shape.clone();
    match &mut shape {
        Shape::Face { outline, holes } => {
            for vertices in holes.iter_mut().chain([outline]) {
                vertices.reverse();
                for vertex in vertices {
                    vertex.normal = vertex.normal.map(|normal| -normal);
                }
            }
        }
        Shape::Ring { normal, .. } => *normal = -*normal,
        Shape::Sphere { inward, .. }
        | Shape::Cylinder { inward, .. }
        | Shape::Cone { inward, .. }
        | Shape::Torus { inward, .. } => *inward = !*inward,
        Shape::Prism { .. } => {}
    }
    shape
}
