//! Into which directions lamps shine.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use traylib_geometry::Normals;
use traylib_math::Vec3;
use traylib_math::glam::{DQuat, DVec3};

/// A bound on directions: every lamp has a direction within `spread` of `axis` and
/// shines up to `reach` away from that, with at most the cosine of how far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cone {
    pub(super) axis: DVec3,
    /// Radians, at most π.
    pub(super) spread: f64,
    pub(super) reach: Reach,
}

/// The angle from its own direction within which a lamp shines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Reach {
    /// Nowhere beyond: `spread` holds all directions it shines into.
    Nowhere,
    /// Half the sphere, like the cosine.
    Hemisphere,
}

impl Reach {
    pub(super) fn cosine(self) -> f32 {
        match self {
            Self::Nowhere => 1.0,
            Self::Hemisphere => 0.0,
        }
    }

    fn radians(self) -> f64 {
        match self {
            Self::Nowhere => 0.0,
            Self::Hemisphere => FRAC_PI_2,
        }
    }
}

impl Cone {
    /// All directions.
    pub(super) const SPHERE: Self = Self { axis: DVec3::Z, spread: PI, reach: Reach::Nowhere };

    /// Around the front normals of a surface that shines like the cosine.
    pub(super) fn around_normals(normals: Normals) -> Self {
        let Normals { axis, half_angle } = normals;
        Self { axis: direction(axis), spread: half_angle, reach: Reach::Hemisphere }
    }

    /// Directions within an angle of an axis.
    pub(super) fn filled(axis: Vec3, cos_max: f32) -> Self {
        let spread = f64::from(cos_max).clamp(-1.0, 1.0).acos();
        Self { axis: direction(axis), spread, reach: Reach::Nowhere }
    }

    /// A cone around both: the smallest, unless they are opposite.
    #[must_use]
    pub(super) fn join(self, other: Self) -> Self {
        let reach = self.reach.max(other.reach);
        let (wide, narrow) =
            if self.spread >= other.spread { (self, other) } else { (other, self) };
        if wide.spread >= PI {
            return Self { reach, ..wide };
        }
        let across = wide.axis.cross(narrow.axis);
        let apart = across.length().atan2(wide.axis.dot(narrow.axis));
        if apart + narrow.spread <= wide.spread {
            return Self { reach, ..wide };
        }
        let spread = 0.5 * (wide.spread + apart + narrow.spread);
        match across.try_normalize() {
            Some(turn) if spread < PI => {
                let axis = DQuat::from_axis_angle(turn, spread - wide.spread) * wide.axis;
                Self { axis, spread, reach }
            }
            _ => Self { reach, ..Self::SPHERE },
        }
    }

    /// Returns the measure of the directions that lamps in it shine into, each weighted with its
    /// cosine, in steradians: M_Ω of Conty Estevez and Kulla.
    pub(super) fn measure(&self) -> f64 {
        let spread = self.spread;
        let end = (spread + self.reach.radians()).min(PI);
        let (sin, cos) = spread.sin_cos();
        let rim = 2.0 * (end - spread) * sin - (spread - 2.0 * end).cos() + cos;
        TAU * (1.0 - cos) + FRAC_PI_2 * rim
    }
}

/// Unit again in double precision, so that angles of turned axes hold.
fn direction(v: Vec3) -> DVec3 {
    v.as_dvec3().normalize_or(DVec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_have_their_closed_forms() {
        let cone = |spread, reach| Cone { axis: DVec3::Z, spread, reach }.measure();
        for (found, known) in [
            (cone(0.0, Reach::Hemisphere), PI),
            (cone(0.0, Reach::Nowhere), 0.0),
            (cone(1.0, Reach::Nowhere), TAU * (1.0 - 1.0_f64.cos())),
            (cone(PI, Reach::Nowhere), 2.0 * TAU),
            (cone(PI, Reach::Hemisphere), 2.0 * TAU),
        ] {
            // A few roundings of numbers around ten.
            assert!((found - known).abs() < 1e-14, "{found} {known}");
        }
    }

    /// Every direction of either is in the joint, which touches both where they
    /// are furthest apart.
    #[test]
    fn a_joint_holds_both_and_no_more() {
        let axes = [Vec3::X, Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.8, 0.0, 0.6), Vec3::NEG_X];
        for (a, b) in axes.iter().flat_map(|&a| axes.map(|b| (a, b))) {
            for (wide, narrow) in [(1.0, 0.9), (0.2, -0.5), (0.9, 0.999), (1.0, 1.0)] {
                let (a, b) = (Cone::filled(a, wide), Cone::filled(b, narrow));
                let joint = a.join(b);
                let apart = a.axis.angle_between(b.axis);
                let known = (0.5 * (apart + a.spread + b.spread)).max(a.spread).max(b.spread);
                // Angles from arc cosines near one are good to 10⁻⁸.
                let close = (joint.spread - known).abs() < 3e-8;
                assert!(close || joint.spread == PI, "{a:?} {b:?} {joint:?}");
                for part in [a, b] {
                    let end = (joint.axis.angle_between(part.axis) + part.spread).min(PI);
                    assert!(end <= joint.spread + 3e-8, "{a:?} {b:?} {joint:?}");
                }
            }
        }
    }

    #[test]
    fn opposite_lamps_shine_everywhere() {
        let [up, down] = [Vec3::Z, Vec3::NEG_Z]
            .map(|axis| Cone::around_normals(Normals { axis, half_angle: 0.0 }));
        assert_eq!(up.join(down), Cone { reach: Reach::Hemisphere, ..Cone::SPHERE });
        assert_eq!(up.join(up), up);
    }
}
