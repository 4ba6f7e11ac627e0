//! Vectors in double precision.

use std::ops::{Add, Mul, Sub};
use traylib_geometry::Vec3;

/// A vector of three doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// Third coordinate.
    pub z: f64,
}

impl Wide {
    /// Along the third axis.
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);
    /// Along the first axis.
    pub const X: Self = Self::new(1.0, 0.0, 0.0);

    /// With these coordinates.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Vector product.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        let Self { x, y, z } = self;
        Self::new(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x)
    }

    /// Length.
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The unit vector along it; not a number for zero.
    #[must_use]
    pub fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// A right-handed basis whose first axis is along this vector.
    pub fn frame(self) -> [Self; 3] {
        let axis = self.unit();
        let aside = if axis.x.abs() < 0.8 { Self::X } else { Self::Z };
        let u = (aside - axis * axis.dot(aside)).unit();
        [axis, u, axis.cross(u)]
    }

    /// Rounded to single precision.
    pub fn narrow(self) -> Vec3 {
        Vec3::new(self.x as f32, self.y as f32, self.z as f32)
    }
}

impl From<Vec3> for Wide {
    fn from(v: Vec3) -> Self {
        Self::new(f64::from(v.x), f64::from(v.y), f64::from(v.z))
    }
}

impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl Mul<f64> for Wide {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_orthonormal_and_right_handed() {
        for axis in [Wide::X, Wide::Z, Wide::new(1.0, -2.0, 0.3)] {
            let [a, b, c] = axis.frame();
            assert!((a.cross(b) - c).length() < 1e-12 && (b.cross(c) - a).length() < 1e-12);
            assert!((a.dot(axis) - axis.length()).abs() < 1e-12);
        }
    }
}
