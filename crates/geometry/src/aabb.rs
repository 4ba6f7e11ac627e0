//! Axis-aligned boxes.

use crate::Vec3;

/// All points between `min` and `max`, borders included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Aabb {
    /// The smallest coordinates.
    pub min: Vec3,
    /// The largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// The box without points: neutral for [`union`](Self::union).
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::extend)
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The smallest box that also holds `point`.
    #[must_use]
    pub fn extend(self, point: Vec3) -> Self {
        Self { min: self.min.min(point), max: self.max.max(point) }
    }

    /// The box with `margin` added on both sides of each axis.
    #[must_use]
    pub fn grown(self, margin: Vec3) -> Self {
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// Edge lengths; negative or not a number when empty.
    pub fn extent(&self) -> Vec3 {
        self.max - self.min
    }

    /// The middle.
    pub fn centre(&self) -> Vec3 {
        // Halves first: the sum of two large coordinates could overflow.
        0.5 * self.min + 0.5 * self.max
    }

    /// Area of the six faces; zero when empty.
    pub fn surface_area(&self) -> f32 {
        if self.is_empty() {
            return 0.0;
        }
        let Vec3 { x, y, z } = self.extent();
        2.0 * (x * y + y * z + z * x)
    }

    /// Tells whether it holds no point.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Tells whether all six borders are numbers and finite (those of [`EMPTY`](Self::EMPTY) are
    /// not).
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Tells whether it holds `point`.
    pub fn contains(&self, point: Vec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_around_points_holds_them_and_no_more() {
        let points = [Vec3::new(1.0, -2.0, 0.0), Vec3::new(0.0, 3.0, 5.0)];
        let bounds = Aabb::around(points);
        assert!(points.iter().all(|&p| bounds.contains(p)));
        assert!(!bounds.contains(Vec3::new(0.5, 3.1, 2.0)));
        assert_eq!(bounds.extent(), Vec3::new(1.0, 5.0, 5.0));
        assert_eq!(bounds.centre(), Vec3::new(0.5, 0.5, 2.5));
        assert_eq!(bounds.surface_area(), 70.0);
    }

    #[test]
    fn the_empty_box_is_neutral() {
        let bounds = Aabb::around([Vec3::ONE]);
        assert_eq!(bounds.union(Aabb::EMPTY), bounds);
        assert!(Aabb::EMPTY.is_empty() && !Aabb::EMPTY.is_finite() && !bounds.is_empty());
        assert_eq!(Aabb::EMPTY.surface_area(), 0.0);
    }
}
