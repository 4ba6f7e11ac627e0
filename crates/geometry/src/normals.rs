//! The directions in which a surface faces.

use crate::Vec3;
use std::f64::consts::PI;

/// A cone of directions that holds all front normals of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normals {
    /// Unit vector in its middle.
    pub axis: Vec3,
    /// The greatest angle between the axis and a normal, in radians: zero on a flat shape,
    /// at most π.
    pub half_angle: f64,
}

impl Normals {
    /// Every direction.
    pub const ALL: Self = Self { axis: Vec3::Z, half_angle: PI };

    /// One direction, a unit vector.
    pub(crate) fn one(axis: Vec3) -> Self {
        Self { axis, half_angle: 0.0 }
    }
}
