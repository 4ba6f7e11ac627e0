//! Boxes as the builder keeps them: aligned, for four numbers at a time.

use crate::Aabb;
use crate::glam::{Vec3A, Vec3Swizzles};

/// A box; 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    min: Vec3A,
    max: Vec3A,
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    #[inline]
    pub(super) fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The lowest and the highest.
    #[inline]
    pub(super) fn corners(self) -> ([f32; 3], [f32; 3]) {
        (self.min.to_array(), self.max.to_array())
    }

    /// Half the area of the faces. What would overflow is the greatest number, so
    /// that areas can always be compared.
    #[inline]
    pub(super) fn area(self) -> f32 {
        let extent = self.max - self.min;
        let area = extent.dot(extent.yzx());
        // In this order not-a-number (infinity times zero) counts as great, too.
        if area < f32::MAX { area } else { f32::MAX }
    }
}

impl From<Aabb> for Bounds {
    fn from(bounds: Aabb) -> Self {
        Self { min: bounds.min.into(), max: bounds.max.into() }
    }
}

impl From<Bounds> for Aabb {
    fn from(bounds: Bounds) -> Self {
        Self { min: bounds.min.into(), max: bounds.max.into() }
    }
}
