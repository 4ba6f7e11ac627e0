//! Similarities: rotations, mirrors, uniform scales and shifts.

use traylib_math::glam::{DMat3, DVec3};

/// p ↦ linear · p + offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    linear: DMat3,
    offset: DVec3,
    /// Factor on lengths, positive.
    pub(super) scale: f64,
    /// True if left and right change places.
    pub(super) mirrored: bool,
}

impl Transform {
    pub(super) const IDENTITY: Self =
        Self { linear: DMat3::IDENTITY, offset: DVec3::ZERO, scale: 1.0, mirrored: false };

    pub(super) fn shift(offset: DVec3) -> Self {
        Self { offset, ..Self::IDENTITY }
    }

    /// Counter-clockwise seen from the tip of `axis` (0, 1, 2 for x, y, z).
    pub(super) fn rotation(axis: usize, degrees: f64) -> Self {
        let radians = degrees.to_radians();
        let linear = match axis {
            0 => DMat3::from_rotation_x(radians),
            1 => DMat3::from_rotation_y(radians),
            _ => DMat3::from_rotation_z(radians),
        };
        Self { linear, ..Self::IDENTITY }
    }

    /// Scales by a factor other than zero; a negative one mirrors at the origin.
    pub(super) fn scaling(factor: f64) -> Self {
        let linear = DMat3::from_diagonal(DVec3::splat(factor));
        Self { linear, offset: DVec3::ZERO, scale: factor.abs(), mirrored: factor < 0.0 }
    }

    /// Negates a coordinate.
    pub(super) fn mirror(axis: usize) -> Self {
        let mut diagonal = DVec3::ONE;
        diagonal[axis] = -1.0;
        Self { linear: DMat3::from_diagonal(diagonal), mirrored: true, ..Self::IDENTITY }
    }

    /// This transform, and `next` after it.
    pub(super) fn then(&self, next: &Self) -> Self {
        Self {
            linear: next.linear * self.linear,
            offset: next.point(self.offset),
            scale: next.scale * self.scale,
            mirrored: next.mirrored != self.mirrored,
        }
    }

    /// This transform so many times.
    pub(super) fn repeated(&self, mut times: u64) -> Self {
        let (mut result, mut power) = (Self::IDENTITY, *self);
        while times > 0 {
            if times % 2 == 1 {
                result = result.then(&power);
            }
            power = power.then(&power);
            times /= 2;
        }
        result
    }

    /// Transforms a point.
    pub(super) fn point(&self, point: DVec3) -> DVec3 {
        self.vector(point) + self.offset
    }

    /// Transforms the difference of two points.
    pub(super) fn vector(&self, vector: DVec3) -> DVec3 {
        self.linear * vector
    }

    /// Transforms a direction into one of length one.
    pub(super) fn direction(&self, direction: DVec3) -> DVec3 {
        (self.vector(direction) / self.scale).normalize_or_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: DVec3, b: DVec3) {
        assert!((a - b).length() < 1e-12, "{a} is not {b}");
    }

    #[test]
    fn rotations_are_counter_clockwise() {
        near(Transform::rotation(0, 90.0).point(DVec3::Y), DVec3::Z);
        near(Transform::rotation(1, 90.0).point(DVec3::Z), DVec3::X);
        near(Transform::rotation(2, 90.0).point(DVec3::X), DVec3::Y);
    }

    #[test]
    fn the_first_one_acts_first() {
        let both = Transform::shift(DVec3::X).then(&Transform::rotation(2, 90.0));
        near(both.point(DVec3::ZERO), DVec3::Y);
        near(both.vector(DVec3::X), DVec3::Y);
    }

    #[test]
    fn repetition_is_composition() {
        let step = Transform::shift(DVec3::X).then(&Transform::rotation(2, 30.0));
        let mut all = Transform::IDENTITY;
        for times in 0..20 {
            let repeated = step.repeated(times);
            near(repeated.point(DVec3::Y), all.point(DVec3::Y));
            all = all.then(&step);
        }
        assert_eq!(Transform::mirror(1).repeated(3), Transform::mirror(1));
    }

    #[test]
    fn scales_and_mirrors_are_remembered() {
        let transform = Transform::scaling(-2.0).then(&Transform::mirror(0));
        assert_eq!((transform.scale, transform.mirrored), (2.0, false));
        near(
            transform.direction(DVec3::new(1.0, 1.0, 0.0)),
            DVec3::new(1.0, -1.0, 0.0).normalize(),
        );
        assert!(Transform::scaling(-1.0).mirrored && Transform::mirror(2).mirrored);
    }
}
