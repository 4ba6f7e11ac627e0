//! The intersection of a ray with a triangle, without gaps at its edges.
//!
//! After Woop, Benthin and Wald, *Watertight Ray/Triangle Intersection*, JCGT 2013: the
//! corners are moved along the ray into a plane, where a corner has the same place for
//! all its triangles, and the ray passes inside if it is on the same side of all edges
//! there. Products are rounded before they are subtracted, so the sign of an edge
//! function is right or zero; zeros are computed again without rounding, and then count
//! as inside.
//!
//! All of it in double precision, in which f32 corners hardly round and nothing over- or
//! underflows. Kernels only leave out triangles that are surely passed by, so all of
//! them agree to the bit.

use crate::ShapeHit;
use crate::precise::{DVec3, difference};
use crate::{Ray, Vec3};

/// The coordinate along which a ray is longest, last of the three; in cyclic order, which
/// interleave no figure over.
///
/// Without branches: the next ray goes anywhere.
#[inline(always)]
pub(crate) fn axes(direction: &Vec3) -> [usize; 3] {
    const CYCLES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
    let size = direction.abs();
    let longest = 2 - usize::from(size.y > size.z);
    let is_other = size.x <= size.y.max(size.z);
    CYCLES[longest * usize::from(is_other)]
}

/// A corner as the ray sees it.
#[derive(Clone, Copy)]
struct Corner {
    /// Its place in the plane in which the ray is the point zero, times the longest
    /// coordinate of the direction, by which nothing has to be divided so.
    place: [f64; 2],
    /// Its distance from the origin along that coordinate.
    depth: f64,
}

/// Returns the hit of a ray with a triangle at 0 < t < `limit`, with the barycentric coordinates of
/// the second and the third corner.
///
/// `axes` are those of the ray, and `corners` have their coordinates in that order.
#[inline(always)]
pub(crate) fn meet(
    ray: &Ray,
    axes: [usize; 3],
    limit: f32,
    corners: [[f32; 3]; 3],
) -> Option<ShapeHit> {
    let direction = pick(&ray.direction, axes).map(f64::from);
    let origin = pick(&ray.origin, axes).map(f64::from);
    let corners = corners.map(|corner| {
        let [x, y, depth] = std::array::from_fn(|i| f64::from(corner[i]) - origin[i]);
        let moved = |from_origin, slope| from_origin * direction[2] - slope * depth;
        Corner { place: [moved(x, direction[0]), moved(y, direction[1])], depth }
    });
    let edges = edges(&corners);
    let [of_a, of_b, of_c] = edges;
    let sum = of_a + of_b + of_c;
    if !is_inside(edges) || sum == 0.0 {
        return None;
    }
    let [a, b, c] = corners;
    let scale = 1.0 / (sum * direction[2]);
    let t = ((of_a * a.depth + of_b * b.depth + of_c * c.depth) * scale) as f32;
    let share = |of: f64| (of * (scale * direction[2])) as f32;
    (0.0 < t && t < limit).then(|| ShapeHit { t, u: share(of_b), v: share(of_c) })
}

/// Three coordinates in another order.
#[inline(always)]
pub(crate) fn pick(v: &Vec3, axes: [usize; 3]) -> [f32; 3] {
    let v: &[f32; 3] = v.as_ref();
    axes.map(|axis| v[axis])
}

/// Twice the areas between the ray and the edge opposite to each corner, of the sign of
/// the side on which the ray is.
#[inline(always)]
fn edges([a, b, c]: &[Corner; 3]) -> [f64; 3] {
    let edge = |p: &Corner, q: &Corner| p.place[0] * q.place[1] - p.place[1] * q.place[0];
    let edges = [edge(b, c), edge(c, a), edge(a, b)];
    if edges.contains(&0.0) {
        let ([ax, ay], [bx, by], [cx, cy]) = (a.place, b.place, c.place);
        return [unrounded(bx, by, cx, cy), unrounded(cx, cy, ax, ay), unrounded(ax, ay, bx, by)];
    }
    edges
}

/// Tells whether all have one sign or are zero. Without branches, since of two triangles one is
/// turned this way and one that way.
#[inline(always)]
fn is_inside([a, b, c]: [f64; 3]) -> bool {
    let lesser = |a, b| if a < b { a } else { b };
    let greater = |a, b| if a > b { a } else { b };
    greater(lesser(lesser(a, b), c), -greater(greater(a, b), c)) >= 0.0
}

/// An edge function of which the sign, and zero, is right, also where both products are
/// rounded to the same number: near the line of an edge, far beyond its ends.
#[cold]
#[inline(never)]
fn unrounded(px: f64, py: f64, qx: f64, qy: f64) -> f64 {
    let (forth, back) = (px * qy, py * qx);
    let rest = px.mul_add(qy, -forth) - py.mul_add(qx, -back);
    if forth == back { rest } else { forth - back }
}

/// The normal of the front, as long as twice the area.
#[inline]
pub(crate) fn normal([a, b, c]: [Vec3; 3]) -> DVec3 {
    difference(b, a).cross(difference(c, a))
}
