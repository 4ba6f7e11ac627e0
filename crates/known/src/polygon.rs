//! Polygons as seen from a point of a diffuse surface, in double precision.

use glam::DVec3;
use std::f64::consts::PI;

/// The share F of the cosine hemisphere around the unit `normal` at `point` that
/// a plane polygon covers, of which only what is above the horizon counts: a
/// lamp of radiance Le gives a diffuse surface ρ·Le·F.
///
/// Lambert's sum over the edges (*Photometria*, 1760): the field cosθ/π of the
/// directions is the curl of another, so its integral over the polygon thrown
/// onto the unit sphere is one along its rim. An edge is an arc there, of angle
/// γᵢ in the plane with unit normal nᵢ, and F = 1/(2π)·Σ γᵢ·(nᵢ·N). The sum's
/// sign is the sense in which the corners go round, which is not asked for.
pub fn factor(point: DVec3, normal: DVec3, corners: &[DVec3]) -> f64 {
    let above = clip(corners, point, normal);
    let to: Vec<DVec3> = above.iter().map(|&corner| corner - point).collect();
    let sum: f64 = edges(&to)
        .map(|(a, b)| {
            let across = a.cross(b);
            let sine = across.length();
            // An edge in line with the point is no arc.
            if sine > 0.0 { sine.atan2(a.dot(b)) * across.dot(normal) / sine } else { 0.0 }
        })
        .sum();
    sum.abs() / (2.0 * PI)
}

/// Returns the part of a convex polygon on the side of the plane through `origin` that
/// `inward` points to.
pub fn clip(corners: &[DVec3], origin: DVec3, inward: DVec3) -> Vec<DVec3> {
    let height = |corner: DVec3| (corner - origin).dot(inward);
    let mut kept = Vec::new();
    for (a, b) in edges(corners) {
        let (from, to) = (height(a), height(b));
        if from >= 0.0 {
            kept.push(a);
        }
        if (from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0) {
            kept.push(a + (b - a) * (from / (from - to)));
        }
    }
    kept
}

/// Returns the part of a convex polygon that is seen from `point` through a convex window, which
/// may lie before or behind it: the part inside the pyramid over the window.
pub fn through(point: DVec3, corners: &[DVec3], window: &[DVec3]) -> Vec<DVec3> {
    let inside = (window[0] + window[1]) * 0.25 + window[2] * 0.5;
    edges(window).fold(corners.to_vec(), |seen, (a, b)| {
        let side = (a - point).cross(b - point);
        clip(&seen, point, side * side.dot(inside - point).signum())
    })
}

/// The corners of the square |x|, |y| ≤ `half_side` at this height.
pub fn square_at(height: f64, half_side: f64) -> [DVec3; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[x, y]| DVec3::new(half_side * x, half_side * y, height))
}

fn edges(corners: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    (0..corners.len()).map(|i| (corners[i], corners[(i + 1) % corners.len()]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::corner_factor;

    fn of_square(x: f64, y: f64, height: f64, half_side: f64) -> f64 {
        factor(DVec3::new(x, y, 0.0), DVec3::Z, &square_at(height, half_side))
    }

    #[test]
    fn squares_have_their_known_factors() {
        for (found, known) in [
            (of_square(0.0, 0.0, 1.0, 1.0), 0.554_126),
            (of_square(1.0, 1.0, 1.0, 1.0), corner_factor(2.0, 2.0)),
            // Two independent quadratures agreed on these.
            (of_square(0.6, 0.0, 3.0, 0.1), 0.001_306_33),
            (of_square(0.8, 0.0, 3.0, 0.1), 0.001_231_74),
            (of_square(1.0, 0.0, 3.0, 0.1), 0.001_144_85),
            (of_square(1.5, 0.0, 3.0, 0.1), 0.000_904_99),
        ] {
            assert!((found - known).abs() < 1e-6, "{found} {known}");
        }
    }

    /// A long wall: what is below the floor adds nothing.
    #[test]
    fn what_is_below_the_horizon_does_not_count() {
        let wall = |low: f64| {
            let corners = [[-1e6, low], [1e6, low], [1e6, 1.0], [-1e6, 1.0]]
                .map(|[y, z]| DVec3::new(1.0, y, z));
            factor(DVec3::new(0.0, 0.0, 0.0), DVec3::Z, &corners)
        };
        // A strip without end fills half the difference of the sines of its
        // angles to the normal, 90° and 45°.
        let known = 0.5 * (1.0 - 0.5_f64.sqrt());
        assert!((wall(0.0) - known).abs() < 1e-6, "{}", wall(0.0));
        assert!((wall(-3.0) - known).abs() < 1e-6, "{}", wall(-3.0));
    }

    #[test]
    fn a_window_shows_a_part() {
        let lamp = square_at(3.0, 0.1);
        // From (x, 0, 0) the window at z = 2 throws |y| ≤ a to |y| ≤ 1.5·a.
        let seen = through(DVec3::new(0.0, 0.0, 0.0), &lamp, &square_at(2.0, 0.04));
        let area_like = factor(DVec3::new(0.0, 0.0, 0.0), DVec3::Z, &seen);
        let known = of_square(0.0, 0.0, 3.0, 0.06);
        assert!((area_like - known).abs() < 1e-12, "{area_like} {known}");
        assert!(through(DVec3::new(2.0, 0.0, 0.0), &lamp, &square_at(2.0, 0.3)).is_empty());
        assert_eq!(through(DVec3::new(0.0, 0.0, 0.0), &lamp, &square_at(2.0, 0.3)).len(), 4);
    }
}
