//! A6 and A7: lamps that are polygons, seen from the origin of the floor.

use crate::analytic::from_aside;
use crate::case::Case;
use crate::polygon::factor;
use crate::stage::{rectangle, triangle};
use glam::DVec3;
use std::f64::consts::PI;
use traylib_geometry::{Primitive, Vec3};

/// A6: a rectangle `high` × `wide` that stands on the floor at the distance
/// `away` and faces the point, one of its lower corners right before it.
pub fn standing(high: f64, wide: f64, away: f64) -> Case {
    let [h, w, c] = [high, wide, away].map(|length| length as f32);
    // z × y is −x.
    let lamp = rectangle(c * Vec3::X, h * Vec3::Z, w * Vec3::Y);
    let name = format!("A6 {high} × {wide} at {away}");
    from_aside(name, &[lamp], standing_factor(high, wide, away))
}

/// F of the rectangle of [`standing`]. Of Lambert's four edges the lower one
/// lies in the horizon, whose plane's normal is the floor's, with the angle
/// atan(b/c); the upper one is tilted, with the angle atan(b/√(a²+c²)) and the
/// cosine c/√(a²+c²); the planes of the plumb edges add nothing. With X = a/b
/// and Y = c/b:
/// 1/(2π)·[atan(1/Y) − Y/√(X²+Y²)·atan(1/√(X²+Y²))].
pub fn standing_factor(high: f64, wide: f64, away: f64) -> f64 {
    let (x, y) = (high / wide, away / wide);
    let slant = x.hypot(y);
    ((1.0 / y).atan() - y / slant * (1.0 / slant).atan()) / (2.0 * PI)
}

/// A7: an irregular triangle, tilted against the floor.
pub fn tilted_triangle() -> Case {
    flat("A7 triangle", &[[0.9, -0.4, 0.5], [0.2, 0.3, 1.4], [1.1, 0.8, 0.7]])
}

/// A7: an irregular pentagon of three triangles, two of its corners below the
/// floor.
pub fn sunk_pentagon() -> Case {
    // In the plane x + 0.25·z = 1.1, in which it is convex.
    let corners = [[-0.7, -0.2], [-0.9, 0.6], [0.1, 1.3], [1.0, 0.5], [0.5, -0.3]];
    flat("A7 pentagon", &corners.map(|[y, z]| [1.1 - 0.25 * z, y, z]))
}

/// A fan of triangles around the first corner of a convex polygon, so turned as
/// to face the origin.
fn flat<const N: usize>(name: &str, corners: &[[f64; 3]; N]) -> Case {
    let corners = corners.map(|[x, y, z]| DVec3::new(x, y, z));
    let towards = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[0]) < 0.0;
    let fan: Vec<Primitive> = (1..N - 1)
        .map(|i| if towards { [0, i, i + 1] } else { [0, i + 1, i] })
        .map(|indices| triangle(indices.map(|i| corners[i].as_vec3())))
        .collect();
    from_aside(name.into(), &fan, factor(DVec3::new(0.0, 0.0, 0.0), DVec3::Z, &corners))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that two independent ways of computing them agreed on, and the
    /// general sum over the edges.
    #[test]
    fn standing_rectangles_have_their_known_factors() {
        for ([a, b, c], known) in [([1.0, 1.0, 1.0], 0.055_734_2), ([2.0, 1.0, 0.5], 0.158_775)] {
            let found = standing_factor(a, b, c);
            assert!((found - known).abs() < 1e-6, "{found}");
            let corners = [[0.0, 0.0], [b, 0.0], [b, a], [0.0, a]];
            let corners = corners.map(|[y, z]| DVec3::new(c, y, z));
            assert!((factor(DVec3::new(0.0, 0.0, 0.0), DVec3::Z, &corners) - found).abs() < 1e-12);
        }
    }
}
