//! A4: a spherical lamp that the horizon cuts.

use crate::analytic::from_aside;
use crate::case::Case;
use crate::stage::ball;
use std::f64::consts::PI;
use traylib_geometry::Vec3;

/// A4: a ball of radius 1 with its centre at the distance `distance`, in a
/// direction of this cosine to the floor's normal, partly below the floor.
pub fn cut_sphere(distance: f64, cosine: f64) -> Case {
    let sine = (1.0 - cosine * cosine).sqrt();
    let centre = Vec3::new((distance * sine) as f32, 0.0, (distance * cosine) as f32);
    let name = format!("A4 d = {distance}, cos θ = {cosine}");
    from_aside(name, &[ball(centre, 1.0)], cut_factor(distance, cosine))
}

/// F of a ball of radius 1 at the distance g, in a direction of cosine m, with
/// |m·g| < 1.
///
/// The ball covers the cone of half-angle asin(1/g), whose rim thrown down onto
/// the unit disk is an ellipse, cut here by the horizon. F is the area of the
/// part of the ellipse beyond the two tangent points, and of the segment of the
/// disk between them, over π; the two terms in that order:
///
/// F = 1/π·{[m·acos(−m·√((g²−1)/(1−m²))) − √((1−g²m²)(g²−1))]/g²
///          + atan √((1−g²m²)/(g²−1))}
pub fn cut_factor(g: f64, m: f64) -> f64 {
    let (outside, cut) = (g * g - 1.0, 1.0 - g * g * m * m);
    let ellipse = m * (-m * (outside / (1.0 - m * m)).sqrt()).acos() - (cut * outside).sqrt();
    (ellipse / (g * g) + (cut / outside).sqrt().atan()) / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that two independent ways of computing them agreed on.
    #[test]
    fn the_cut_ball_has_its_known_factors() {
        for (g, m, known) in [
            (2.0, 0.3, 0.078_715),
            (2.0, 0.0, 0.028_834),
            (2.0, -0.3, 0.003_715),
            (1.1, 0.2, 0.330_183),
        ] {
            let found = cut_factor(g, m);
            assert!((found - known).abs() < 1e-6, "{g} {m}: {found}");
        }
    }

    /// Where the ball just touches the horizon, all of it counts or nothing.
    #[test]
    fn the_cut_begins_and_ends_where_the_ball_touches_the_horizon() {
        let almost = 0.5 * (1.0 - 1e-12);
        assert!((cut_factor(2.0, almost) - 0.25 * 0.5).abs() < 1e-6);
        assert!(cut_factor(2.0, -almost).abs() < 1e-6);
    }
}
