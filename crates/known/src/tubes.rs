//! A10: lamps that are tubes and cones, whose fronts face more than one way.
//!
//! A point outside of a convex surface sees all of its front that faces the point,
//! so F is the integral of cosθ·cosθ'/(π·d²) over the surface with negative cosines
//! left out. It is smooth but for a kink, and is summed by midpoints.

use crate::analytic::from_aside;
use crate::case::Case;
use crate::stage::tube;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The side of a truncated cone with its front outside.
struct Side {
    ends: [DVec3; 2],
    radii: [f64; 2],
}

/// Two slender cones and a tube around the floor's point, all above the floor and
/// none before another.
pub fn cones_and_a_tube() -> Case {
    let side = |ends: [[f64; 3]; 2], radii| Side { ends: ends.map(DVec3::from_array), radii };
    let sides = [
        side([[-0.5, 0.75, 1.0], [0.5, 0.75, 1.25]], [0.125, 0.25]),
        side([[0.75, -0.75, 1.0], [-0.75, -1.0, 1.0]], [0.25, 0.0]),
        side([[1.0, 0.25, 0.5], [1.0, 0.0, 1.0]], [0.125, 0.125]),
    ];
    let lamp = |side: &Side| tube(side.ends.map(DVec3::as_vec3), side.radii.map(|r| r as f32));
    let factor = sides.iter().map(|side| side.factor(1024)).sum();
    from_aside("A10".into(), &sides.each_ref().map(lamp), factor)
}

impl Side {
    /// F for the origin of the floor, by `steps` squared midpoints.
    fn factor(&self, steps: i32) -> f64 {
        let [first, last] = self.ends;
        let axis = last - first;
        let widening = self.radii[1] - self.radii[0];
        let slant = axis.length().hypot(widening);
        let across = axis.any_orthogonal_vector().normalize();
        let beside = axis.normalize().cross(across);
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(steps);
        let patch = |i: i32| {
            let (height, turn) = (middle(i / steps), TAU * middle(i % steps));
            let outward = across * turn.cos() + beside * turn.sin();
            let radius = self.radii[0] + height * widening;
            let point = first + axis * height + outward * radius;
            let normal = (outward * axis.length() - axis.normalize() * widening) / slant;
            let facing = -normal.dot(point);
            let square = point.length_squared();
            // Cosines are over d each.
            facing.max(0.0) * point.z.max(0.0) / (PI * square * square) * TAU * radius * slant
        };
        (0..steps * steps).map(patch).sum::<f64>() / f64::from(steps * steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cone straight above the point, its tip down, looks like the disk in its
    /// wide end, F = R²/(R² + h²), and without its tip like the ring that is left.
    /// Of a tube the point sees the inside alone.
    #[test]
    fn cones_above_the_point_look_like_disks() {
        let above = |radii, heights: [f64; 2]| {
            Side { ends: heights.map(|z| DVec3::new(0.0, 0.0, z)), radii }.factor(512)
        };
        let wide = above([0.0, 1.0], [1.0, 2.0]);
        assert!((wide - 0.2).abs() < 1e-5, "{wide}");
        let ring = above([0.25, 1.0], [1.0, 2.0]);
        assert!((ring - (0.2 - 0.0625 / 1.0625)).abs() < 1e-5, "{ring}");
        assert_eq!(above([0.5, 0.5], [1.0, 2.0]), 0.0);
    }

    #[test]
    fn steps_are_small_enough() {
        let ends = [DVec3::new(0.75, -0.75, 1.0), DVec3::new(-0.75, -1.0, 1.0)];
        let side = Side { ends, radii: [0.25, 0.0] };
        assert!((side.factor(512) / side.factor(1024) - 1.0).abs() < 1e-5);
    }
}
