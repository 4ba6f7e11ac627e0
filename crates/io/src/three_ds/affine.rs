//! Affine maps, which turn, stretch and move, in double precision.

use super::wide::{self, Wide};
use traylib_math::Vec3;

/// A linear map and a shift after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// The images of the unit vectors.
    axes: [Wide; 3],
    origin: Wide,
}

impl Affine {
    /// Leaves everything where it is.
    pub const IDENTITY: Self =
        Self { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// The map that takes the unit vectors to `axes` and 0 to `origin`.
    pub fn new(axes: [Vec3; 3], origin: Vec3) -> Self {
        Self { axes: axes.map(wide::widen), origin: wide::widen(origin) }
    }

    pub(super) fn translation(by: Vec3) -> Self {
        Self { origin: wide::widen(by), ..Self::IDENTITY }
    }

    pub(super) fn scaling(by: Vec3) -> Self {
        let [x, y, z] = wide::widen(by);
        Self { axes: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], ..Self::IDENTITY }
    }

    /// A turn about an axis through 0, counter-clockwise seen against it, by an
    /// angle in radians. An axis without direction turns nothing.
    pub(super) fn rotation(axis: Vec3, angle: f64) -> Self {
        let Some(axis) = wide::unit(wide::widen(axis)) else { return Self::IDENTITY };
        let (sine, cosine) = angle.sin_cos();
        let turned = |v: Wide| {
            let along = wide::times(axis, wide::dot(axis, v) * (1.0 - cosine));
            let across = wide::times(wide::cross(axis, v), sine);
            wide::add(wide::add(wide::times(v, cosine), across), along)
        };
        Self { axes: Self::IDENTITY.axes.map(turned), ..Self::IDENTITY }
    }

    /// First `first`, then this.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self { axes: first.axes.map(|axis| self.linear(axis)), origin: self.wide(first.origin) }
    }

    /// The way back; `None` if space is flattened, or almost.
    pub fn inverse(&self) -> Option<Self> {
        if self.is_singular() {
            return None;
        }
        let [x, y, z] = self.axes;
        let scale = 1.0 / self.determinant();
        let rows = [wide::cross(y, z), wide::cross(z, x), wide::cross(x, y)];
        let rows = rows.map(|row| wide::times(row, scale));
        let axes = [0, 1, 2].map(|i| rows.map(|row| row[i]));
        let linear = Self { axes, origin: [0.0; 3] };
        Some(Self { origin: wide::times(linear.linear(self.origin), -1.0), ..linear })
            .filter(Self::is_finite)
    }

    /// The factor on volumes, less than 0 if left becomes right.
    pub fn determinant(&self) -> f64 {
        let [x, y, z] = self.axes;
        wide::dot(wide::cross(x, y), z)
    }

    /// Tells whether the axes span less than 10⁻¹² of what they could at right angles,
    /// which is far below what the single precision of files can mean.
    pub fn is_singular(&self) -> bool {
        let lengths = self.axes.map(|axis| wide::dot(axis, axis).sqrt());
        let most: f64 = lengths.iter().product();
        let regular = self.determinant().abs() > 1e-12 * most;
        // What is not a number is not regular.
        !regular
    }

    /// Tells whether all its numbers are.
    pub fn is_finite(&self) -> bool {
        self.axes.iter().chain([&self.origin]).flatten().all(|x| x.is_finite())
    }

    /// Maps a point.
    pub fn point(&self, point: Vec3) -> Vec3 {
        wide::narrow(self.wide(wide::widen(point)))
    }

    fn wide(&self, point: Wide) -> Wide {
        wide::add(self.linear(point), self.origin)
    }

    fn linear(&self, [x, y, z]: Wide) -> Wide {
        let [along_x, along_y, along_z] = self.axes;
        let plane = wide::add(wide::times(along_x, x), wide::times(along_y, y));
        wide::add(plane, wide::times(along_z, z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn some() -> Affine {
        let turned = Affine::rotation(Vec3::new(1.0, 2.0, -1.0), 0.7);
        let scaled = turned.after(&Affine::scaling(Vec3::new(2.0, -3.0, 0.5)));
        Affine::translation(Vec3::new(4.0, 5.0, 6.0)).after(&scaled)
    }

    #[test]
    fn turns_are_counter_clockwise_seen_against_the_axis() {
        let turned = Affine::rotation(Vec3::Z * 3.0, FRAC_PI_2).point(Vec3::X);
        assert!((turned - Vec3::Y).length() < 1e-7, "{turned}");
        assert_eq!(Affine::rotation(Vec3::ZERO, 1.0), Affine::IDENTITY);
    }

    #[test]
    fn the_first_map_comes_first() {
        let up = Affine::translation(Vec3::Z);
        let double = Affine::scaling(Vec3::splat(2.0));
        assert_eq!(double.after(&up).point(Vec3::ZERO), Vec3::Z * 2.0);
        assert_eq!(up.after(&double).point(Vec3::ZERO), Vec3::Z);
    }

    #[test]
    fn there_and_back_is_nowhere() {
        let back = some().inverse().unwrap();
        let point = Vec3::new(-3.0, 0.1, 7.0);
        assert!((back.point(some().point(point)) - point).length() < 1e-5);
        assert!((some().determinant() + 3.0).abs() < 1e-12);
    }

    #[test]
    fn what_flattens_has_no_way_back_at_any_size() {
        for size in [1e-20, 1.0, 1e20] {
            let axes = [Vec3::X, Vec3::Y, Vec3::X + Vec3::Y].map(|axis| axis * size);
            assert_eq!(Affine::new(axes, Vec3::ZERO).inverse(), None);
            let cube = Affine::scaling(Vec3::splat(size));
            assert!(cube.inverse().is_some(), "{size}");
        }
        assert!(Affine::scaling(Vec3::new(f32::NAN, 1.0, 1.0)).is_singular());
        assert!(Affine::scaling(Vec3::ZERO).is_singular());
    }
}
