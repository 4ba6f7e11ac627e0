//! Holes joined to the outline by seams, each walked both ways.

use crate::mgf::Vertex;
use crate::mgf::shape::newell;
use crate::polygon::{Projection, turn};
use traylib_math::glam::DVec2;

/// One polygon for an outline and its holes.
///
/// Holes are joined from right to left, each from its rightmost corner to one
/// that is seen from there: no seam crosses another one or an edge, if the
/// loops do not.
pub(super) fn joined(outline: &[Vertex], holes: &[Vec<Vertex>]) -> Vec<Vertex> {
    let normal = newell(outline);
    let projection = Projection::along(normal);
    let mut order: Vec<(usize, &Vec<Vertex>)> =
        holes.iter().map(|hole| (rightmost(hole, projection), hole)).collect();
    let right = |&(index, hole): &(usize, &Vec<Vertex>)| projection.point(hole[index].position).x;
    order.retain(|(_, hole)| !hole.is_empty());
    order.sort_by(|a, b| right(b).total_cmp(&right(a)));
    let mut polygon = outline.to_vec();
    for (start, hole) in order {
        let points: Vec<DVec2> = polygon.iter().map(|v| projection.point(v.position)).collect();
        let end = seen_from(&points, projection.point(hole[start].position));
        let around = around(hole, start, newell(hole).dot(normal) > 0.0);
        let seam = around.into_iter().chain(polygon.get(end).copied()).collect::<Vec<_>>();
        let after = (end + 1).min(polygon.len());
        polygon.splice(after..after, seam);
    }
    polygon
}

fn rightmost(hole: &[Vertex], projection: Projection) -> usize {
    let x = |index: &usize| projection.point(hole[*index].position).x;
    (0..hole.len()).max_by(|a, b| x(a).total_cmp(&x(b))).unwrap_or(0)
}

/// Returns the way once around a hole and back to its start, against the outline's sense.
fn around(hole: &[Vertex], start: usize, backward: bool) -> Vec<Vertex> {
    let step = if backward { hole.len() - 1 } else { 1 };
    (0..=hole.len()).map(|count| hole[(start + count * step) % hole.len()]).collect()
}

/// A corner of a counter-clockwise polygon that is seen from a point inside.
fn seen_from(points: &[DVec2], eye: DVec2) -> usize {
    let Some((hit, corner)) = look_right(points, eye) else { return nearest(points, eye) };
    // Whatever hides that corner lies in the triangle between; of all corners
    // there the one nearest in angle is not hidden itself.
    let corners = [eye, hit, points[corner]];
    let angle = |index: &usize| {
        let to = points[*index] - eye;
        let tangent = if to.y == 0.0 { 0.0 } else { to.y.abs() / to.x };
        (tangent, to.x)
    };
    (0..points.len())
        .filter(|&index| points[index].x >= eye.x && inside(corners, points[index]))
        .filter(|&index| opens_to(points, index, eye))
        .min_by(|a, b| {
            let (a, b) = (angle(a), angle(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        })
        .unwrap_or(corner)
}

/// Returns the point at which the view to the right ends, and the right one of that edge's corners.
fn look_right(points: &[DVec2], eye: DVec2) -> Option<(DVec2, usize)> {
    let mut best: Option<(DVec2, usize)> = None;
    for (index, &a) in points.iter().enumerate() {
        let next = (index + 1) % points.len();
        let b = points[next];
        // From inside, edges to the right are met going up.
        if !(a.y <= eye.y && eye.y <= b.y && a.y < b.y) {
            continue;
        }
        let x = a.x + (eye.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if x >= eye.x && best.is_none_or(|(hit, _)| x < hit.x) {
            best = Some((DVec2::new(x, eye.y), if a.x > b.x { index } else { next }));
        }
    }
    best
}

fn nearest(points: &[DVec2], eye: DVec2) -> usize {
    let distance = |index: &usize| points[*index].distance_squared(eye);
    (0..points.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// Tells whether a point is in a triangle of either sense, its border included.
fn inside([a, b, c]: [DVec2; 3], point: DVec2) -> bool {
    let turns = [turn(a, b, point), turn(b, c, point), turn(c, a, point)];
    turns.iter().all(|&t| t >= 0.0) || turns.iter().all(|&t| t <= 0.0)
}

/// Tells whether the polygon's inside at a corner is toward a point. Where corners of
/// several seams coincide, it is at one of them.
fn opens_to(points: &[DVec2], index: usize, eye: DVec2) -> bool {
    let count = points.len();
    let (before, corner, after) =
        (points[(index + count - 1) % count], points[index], points[(index + 1) % count]);
    let (left_in, left_out) = (turn(before, corner, eye) >= 0.0, turn(corner, after, eye) >= 0.0);
    if turn(before, corner, after) >= 0.0 { left_in && left_out } else { left_in || left_out }
}
