//! The part of one surface's light that reaches another: form factors between whole
//! surfaces.
//!
//! A pinhole that looks straight down at the floor is a similarity: equal parts
//! of the film see equal areas. So the mean over the film is the mean of the
//! radiance over what is seen of the plane, and a diffuse patch of area A, all
//! of it in view and nothing else there, makes it ρ·Le·F·A/(area seen), with F
//! the mean over the patch of the share that the lamp covers of the hemisphere.
//! That is the share of the patch's own light that would reach the lamp, and
//! A·F is the same both ways.

use crate::case::Case;
use crate::stage::{Stage, black, camera, disk_facing_down, disk_facing_up, lambert, rectangle};
use std::f64::consts::PI;
use traylib_geometry::{Primitive, Vec3};

const REFLECTANCE: f64 = 0.5;
const RADIANCE: f64 = 3.0;

/// Above all lamps: their backs are not there.
const EYE: f32 = 8.0;

/// Two disks of radius 1 that face each other across the distance h. With
/// X = 2 + h², F = (X − √(X² − 4))/2: the solution of F² − X·F + 1 = 0 that the
/// sum over rings of the field of a disk comes to (Walton, *Calculation of
/// obstructed view factors by adaptive integration*, 2002, gives the integral).
pub fn disks(distance: f64) -> Case {
    let lamp = disk_facing_down(distance as f32 * Vec3::Z, 1.0);
    let patch = disk_facing_up(Vec3::ZERO, 1.0);
    let truth = REFLECTANCE * RADIANCE * disks_factor(distance) * PI / 4.0;
    seen_from_above(format!("disks at {distance}"), lamp, patch, truth)
}

/// See [`disks`].
pub fn disks_factor(distance: f64) -> f64 {
    let x = 2.0 + distance * distance;
    0.5 * (x - (x * x - 4.0).sqrt())
}

/// Opposite sides of a cube: F = 0.19982490.
pub fn opposite_sides() -> Case {
    // y × x points down.
    let lamp = rectangle(Vec3::new(-1.0, -1.0, 2.0), 2.0 * Vec3::Y, 2.0 * Vec3::X);
    let truth = REFLECTANCE * RADIANCE * OPPOSITE;
    seen_from_above("opposite sides".into(), lamp, side_below(), truth)
}

/// Adjacent sides of a cube: F = 0.20004378, so that one opposite and four
/// adjacent sides see everything there is.
///
/// Near the common edge the kernel G = cosθ·cosθ'/d² has no bound.
pub fn corner() -> Case {
    // y × z is x.
    let lamp = rectangle(Vec3::new(-1.0, -1.0, 0.0), 2.0 * Vec3::Y, 2.0 * Vec3::Z);
    let truth = REFLECTANCE * RADIANCE * ADJACENT;
    seen_from_above("D1 corner".into(), lamp, side_below(), truth)
}

/// The integral of [`corner_factor`](crate::analytic::corner_factor) over a
/// square, and what it leaves to the four other sides.
const OPPOSITE: f64 = 0.199_824_90;
const ADJACENT: f64 = 0.200_043_78;

fn side_below() -> Primitive {
    rectangle(Vec3::new(-1.0, -1.0, 0.0), 2.0 * Vec3::X, 2.0 * Vec3::Y)
}

/// The square |x|, |y| ≤ 1 of the floor's plane fills the film.
fn seen_from_above(name: String, lamp: Primitive, patch: Primitive, truth: f64) -> Case {
    let angle = 2.0 * EYE.recip().atan().to_degrees();
    let scene = Stage::new(camera(EYE * Vec3::Z, Vec3::ZERO, angle, 32))
        .surface(patch, lambert(REFLECTANCE as f32))
        .light(lamp, RADIANCE as f32, black())
        .build();
    Case { name, scene, max_depth: None, truth }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::factor;
    use crate::polygonal::standing_factor;
    use crate::{analytic::corner_factor, polygon::square_at};
    use glam::DVec3;

    #[test]
    fn disks_have_their_known_factors() {
        for (distance, known) in [(1.0, 0.381_966), (2.0, 0.171_573)] {
            let found = disks_factor(distance);
            assert!((found - known).abs() < 1e-6, "{found}");
        }
    }

    /// The integral is taken by midpoints over the lower side, of half-side 1.
    #[test]
    fn sides_of_a_cube_have_their_known_factors() {
        let steps = 400;
        let middle = |i: i32| -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(steps);
        let (mut opposite, mut adjacent) = (0.0, 0.0);
        for i in 0..steps * steps {
            let (x, y) = (middle(i % steps), middle(i / steps));
            let strip =
                |y: f64| corner_factor(0.5 * (1.0 - x), y) + corner_factor(0.5 * (1.0 + x), y);
            opposite += strip(0.5 * (1.0 - y)) + strip(0.5 * (1.0 + y));
            let beside = |wide: f64| standing_factor(2.0, wide, 1.0 + x);
            adjacent += beside(1.0 - y) + beside(1.0 + y);
        }
        let count = f64::from(steps * steps);
        assert!((opposite / count - OPPOSITE).abs() < 1e-6, "{}", opposite / count);
        // The integrand is half a disk at the edge, with a steep end.
        assert!((adjacent / count - ADJACENT).abs() < 1e-5, "{}", adjacent / count);
        assert!((OPPOSITE + 4.0 * ADJACENT - 1.0).abs() < 1e-7);
        let middle = factor(DVec3::new(0.0, 0.0, 0.0), DVec3::Z, &square_at(2.0, 1.0));
        assert!((middle - 4.0 * corner_factor(0.5, 0.5)).abs() < 1e-12);
    }
}
