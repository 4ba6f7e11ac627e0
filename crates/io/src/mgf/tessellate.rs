//! Shapes as flat polygons and triangles.

mod revolve;
mod seam;

use super::shape::newell;
use super::{Shape, Vertex};
use crate::polygon;
use revolve::{Axis, Rim};
use std::f64::consts::{FRAC_PI_2, TAU};
use traylib_math::glam::DVec3;

/// The usual number of divisions of a quarter circle: circles get 20 sides.
pub const DEFAULT_DIVISIONS: u32 = 5;

/// More divisions than these are not made: a sphere has 16 triangles for the
/// square of their number.
pub const MAX_DIVISIONS: u32 = 256;

/// The shape as polygons whose corners lie on it, each counter-clockwise seen
/// from its front. Those of round shapes have their normals.
///
/// With q `divisions` of a quarter circle a sphere has 8q² polygons, a torus
/// 16q², a cylinder, cone or ring 4q. A face with holes is one polygon whose
/// holes are joined to its outline.
pub fn polygons(shape: &Shape, divisions: u32) -> Vec<Vec<Vertex>> {
    let divisions = divisions.clamp(1, MAX_DIVISIONS);
    match shape {
        Shape::Face { outline, holes } => vec![seam::joined(outline, holes)],
        Shape::Prism { outline, offset, .. } => prism(outline, *offset),
        Shape::Sphere { centre, radius, inward } => {
            let axis = Axis { base: *centre, direction: DVec3::Z, inward: *inward };
            axis.revolve(&sphere(*radius, divisions), divisions)
        }
        Shape::Cylinder { ends, radius, inward } => cone(*ends, [*radius; 2], *inward, divisions),
        Shape::Cone { ends, radii, inward } => cone(*ends, *radii, *inward, divisions),
        Shape::Ring { centre, normal, radii: [inner, outer] } => {
            let rim = |radius| Rim { radius, height: 0.0, normal: [0.0, 1.0] };
            let axis = Axis { base: *centre, direction: *normal, inward: false };
            axis.revolve(&[rim(*outer), rim(*inner)], divisions)
        }
        Shape::Torus { centre, normal, radius, tube_radius, inward } => {
            let axis = Axis { base: *centre, direction: *normal, inward: *inward };
            axis.revolve(&torus(*radius, *tube_radius, divisions), divisions)
        }
    }
}

/// The shape as triangles, counter-clockwise seen from the front. Each has area,
/// and three normals or none.
///
/// Takes time with the square of a polygon's corners.
pub fn triangles(shape: &Shape, divisions: u32) -> Vec<[Vertex; 3]> {
    polygons(shape, divisions).into_iter().flat_map(cut).collect()
}

fn cut(mut polygon: Vec<Vertex>) -> Vec<[Vertex; 3]> {
    let normal = newell(&polygon);
    complete_normals(&mut polygon, normal);
    let triangles = polygon::cut(polygon.iter().map(|vertex| vertex.position), normal);
    triangles.into_iter().map(|corners| corners.map(|index| polygon[index])).collect()
}

/// Gives the normal of the plane to corners without one, if others have one, and turns normals that
/// point to the back.
fn complete_normals(polygon: &mut [Vertex], plane: DVec3) {
    if polygon.iter().all(|vertex| vertex.normal.is_none()) {
        return;
    }
    let plane = plane.normalize_or(DVec3::Z);
    for vertex in polygon {
        let normal = vertex.normal.unwrap_or(plane);
        vertex.normal = Some(if normal.dot(plane) < 0.0 { -normal } else { normal });
    }
}

/// Both ends and a side for every edge. Vertex normals are for the sides.
fn prism(outline: &[Vertex], offset: DVec3) -> Vec<Vec<Vertex>> {
    let plain = |position| Vertex { position, normal: None };
    let moved = |vertex: &Vertex| Vertex { position: vertex.position + offset, ..*vertex };
    let near = outline.iter().map(|vertex| plain(vertex.position)).collect();
    let far = outline.iter().rev().map(|vertex| plain(moved(vertex).position)).collect();
    let next = outline.iter().cycle().skip(1);
    let sides = outline.iter().zip(next).map(|(a, b)| vec![*a, moved(a), moved(b), *b]);
    [near, far].into_iter().chain(sides).collect()
}

fn cone(ends: [DVec3; 2], radii: [f64; 2], inward: bool, divisions: u32) -> Vec<Vec<Vertex>> {
    let along = ends[1] - ends[0];
    let length = along.length();
    let slope = length.hypot(radii[0] - radii[1]);
    let normal = [length / slope, (radii[0] - radii[1]) / slope];
    let rim = |radius, height| Rim { radius, height, normal };
    let axis = Axis { base: ends[0], direction: along / length, inward };
    axis.revolve(&[rim(radii[0], 0.0), rim(radii[1], length)], divisions)
}

/// From the south pole to the north pole.
fn sphere(radius: f64, divisions: u32) -> Vec<Rim> {
    let rim = |index: u32| {
        let from_south = FRAC_PI_2 * f64::from(index) / f64::from(divisions);
        let (sin, cos) = (from_south - FRAC_PI_2).sin_cos();
        let cos = if index == 0 || index == 2 * divisions { 0.0 } else { cos };
        Rim { radius: radius * cos, height: radius * sin, normal: [cos, sin] }
    };
    (0..=2 * divisions).map(rim).collect()
}

/// Returns the rims once around the tube, upward on its outside.
fn torus(radius: f64, tube_radius: f64, divisions: u32) -> Vec<Rim> {
    let sides = 4 * divisions;
    let rim = |index: u32| {
        let (sin, cos) = (TAU * f64::from(index % sides) / f64::from(sides)).sin_cos();
        let normal = [cos, sin];
        Rim { radius: radius + tube_radius * cos, height: tube_radius * sin, normal }
    };
    (0..=sides).map(rim).collect()
}

#[cfg(test)]
mod tests;
