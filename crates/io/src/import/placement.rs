//! The placement of a mesh from a file.

use traylib_math::Vec3;
use traylib_math::glam::{DAffine3, DVec3, Mat3};

/// Scale, then turn, then move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    scale: f32,
    rotation: Mat3,
    translation: Vec3,
}

impl Placement {
    /// Leaves everything where it is.
    pub(super) const NONE: Self =
        Self { scale: 1.0, rotation: Mat3::IDENTITY, translation: Vec3::ZERO };

    /// The placement a scene file describes; the field that makes no sense and
    /// what is wrong with it, else.
    pub(super) fn new(
        scale: f32,
        rotate: [f32; 3],
        translate: [f32; 3],
    ) -> Result<Self, (&'static str, &'static str)> {
        let (rotate, translation) = (Vec3::from(rotate), Vec3::from(translate));
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(("scale", "the scale must be positive and finite"));
        }
        if !rotate.is_finite() {
            return Err(("rotate", "the angles must be finite"));
        }
        if !translation.is_finite() {
            return Err(("translate", "the translation must be finite"));
        }
        Ok(Self { scale, rotation: rotation(rotate), translation })
    }

    pub(super) fn point(&self, point: Vec3) -> Vec3 {
        self.rotation * (point * self.scale) + self.translation
    }

    /// Places a point of double precision.
    pub(super) fn wide_point(&self, point: DVec3) -> DVec3 {
        let turned = self.rotation.as_dmat3() * (point * f64::from(self.scale));
        turned + self.translation.as_dvec3()
    }

    /// All of it as one.
    pub(super) fn affine(&self) -> DAffine3 {
        let matrix3 = self.rotation.as_dmat3() * f64::from(self.scale);
        DAffine3 { matrix3, translation: self.translation.as_dvec3() }
    }

    /// Metres a unit.
    pub(super) fn scale(&self) -> f64 {
        f64::from(self.scale)
    }

    /// A direction of double precision, of length one.
    pub(super) fn wide_direction(&self, direction: DVec3) -> DVec3 {
        (self.rotation.as_dmat3() * direction).normalize_or_zero()
    }

    /// A unit direction stays one.
    pub(super) fn direction(&self, direction: Vec3) -> Vec3 {
        (self.rotation * direction).normalize()
    }
}

/// About x, then about y, then about z; angles in degrees, counter-clockwise
/// seen against the axis.
fn rotation(degrees: Vec3) -> Mat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(sine_and_cosine);
    let x = Mat3::from_cols(Vec3::X, Vec3::new(0.0, cx, sx), Vec3::new(0.0, -sx, cx));
    let y = Mat3::from_cols(Vec3::new(cy, 0.0, -sy), Vec3::Y, Vec3::new(sy, 0.0, cy));
    let z = Mat3::from_cols(Vec3::new(cz, sz, 0.0), Vec3::new(-sz, cz, 0.0), Vec3::Z);
    z * y * x
}

/// Exact for right angles, so that what stood flat in a file lies flat in the
/// scene.
fn sine_and_cosine(degrees: f32) -> (f32, f32) {
    let turn = degrees.rem_euclid(360.0);
    match turn {
        0.0 | 360.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => {
            let (sine, cosine) = f64::from(turn).to_radians().sin_cos();
            (sine as f32, cosine as f32)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placement(scale: f32, rotate: [f32; 3], translate: [f32; 3]) -> Placement {
        Placement::new(scale, rotate, translate).unwrap()
    }

    #[test]
    fn a_quarter_turn_makes_z_up_y_up_exactly() {
        let upright = placement(1.0, [-90.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(upright.point(Vec3::Z), Vec3::Y);
        assert_eq!(upright.point(Vec3::Y), Vec3::NEG_Z);
        assert_eq!(upright.point(Vec3::X), Vec3::X);
    }

    #[test]
    fn the_order_is_scale_x_y_z_translate() {
        let placed = placement(2.0, [90.0, 90.0, 90.0], [1.0, 0.0, 0.0]);
        // y → z about x, z → x about y, x → y about z.
        assert_eq!(placed.point(Vec3::Y), Vec3::new(1.0, 2.0, 0.0));
        assert_eq!(placed.direction(Vec3::Y), Vec3::Y);
    }

    #[test]
    fn other_angles_keep_lengths() {
        let placed = placement(1.0, [10.0, -200.0, 33.0], [0.0; 3]);
        let v = Vec3::new(1.0, -2.0, 3.0);
        assert!((placed.point(v).length() - v.length()).abs() < 1e-6);
    }
}
