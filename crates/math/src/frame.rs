//! Orthonormal bases.

use crate::Vec3;

/// A right-handed orthonormal basis around a given third axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First axis.
    pub x: Vec3,
    /// Second axis.
    pub y: Vec3,
    /// The axis it was built around.
    pub z: Vec3,
}

impl Frame {
    /// A basis around the unit vector `z`, without branches and accurate
    /// everywhere.
    ///
    /// Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 2017.
    #[inline]
    pub fn around(z: Vec3) -> Self {
        // Zero has no sign here: −0 is what turning and moving make of 0.
        let sign = if z.z < 0.0 { -1.0 } else { 1.0 };
        let a = -1.0 / (sign + z.z);
        let b = z.x * z.y * a;
        Self {
            x: Vec3::new(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x),
            y: Vec3::new(b, sign + z.y * z.y * a, -z.y),
            z,
        }
    }

    /// The vector with coordinates `local` in this basis.
    #[inline]
    pub fn to_world(&self, local: Vec3) -> Vec3 {
        self.x * local.x + self.y * local.y + self.z * local.z
    }

    /// The coordinates of `world` in this basis.
    #[inline]
    pub fn to_local(&self, world: Vec3) -> Vec3 {
        Vec3::new(world.dot(self.x), world.dot(self.y), world.dot(self.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXES: [Vec3; 6] = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z];

    #[test]
    fn bases_are_orthonormal_and_right_handed() {
        let tilted =
            [Vec3::new(1.0, 2.0, -3.0).normalize(), Vec3::new(1e-4, -1e-4, -1.0).normalize()];
        for z in AXES.into_iter().chain(tilted) {
            let Frame { x, y, .. } = Frame::around(z);
            assert!((x.length() - 1.0).abs() < 1e-6 && (y.length() - 1.0).abs() < 1e-6);
            assert!(x.dot(y).abs() < 1e-6 && x.dot(z).abs() < 1e-6 && y.dot(z).abs() < 1e-6);
            assert!((x.cross(y) - z).length() < 1e-6, "{z}");
        }
    }

    /// The sign of a normal's zero must not turn what is sampled around it.
    #[test]
    fn zero_has_no_sign() {
        let frame = |z| Frame::around(Vec3::new(0.6, 0.8, z));
        assert_eq!((frame(0.0).x, frame(0.0).y), (frame(-0.0).x, frame(-0.0).y));
    }

    #[test]
    fn local_and_world_are_inverse() {
        let frame = Frame::around(Vec3::new(0.3, -0.4, 0.5).normalize());
        let v = Vec3::new(1.0, -2.0, 3.0);
        assert!((frame.to_world(frame.to_local(v)) - v).length() < 1e-6);
    }
}
