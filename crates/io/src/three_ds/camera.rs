//! Cameras of a 3DS file.

use super::chunk::Reader;
use super::{ObjectFlags, WarningKind, Warnings};
use traylib_math::Vec3;

/// A camera as stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Name of the object.
    pub name: String,
    /// Marks of the object.
    pub flags: ObjectFlags,
    /// The position; finite.
    pub position: Vec3,
    /// The place that it looks at; finite.
    pub target: Vec3,
    /// Turn about the direction of view, in degrees.
    pub roll_degrees: f32,
    /// Focal length in millimetres of a film for which 53.333 is 45°.
    pub lens: f32,
    /// Near and far range of what is shown.
    pub ranges: Option<[f32; 2]>,
}

/// The field of view for a lens that cannot be, in degrees.
const DEFAULT_FOV_DEGREES: f32 = 45.0;
/// A picture on a plane cannot show half of everything.
const WIDEST_FOV_DEGREES: f32 = 179.0;

impl Camera {
    /// Horizontal field of view in degrees: 2400 / lens, as 3D Studio stores it;
    /// 45° for a lens of 0 or less, at most 179°.
    pub fn fov_degrees(&self) -> f32 {
        if self.lens > 0.0 {
            (2400.0 / self.lens).min(WIDEST_FOV_DEGREES)
        } else {
            DEFAULT_FOV_DEGREES
        }
    }

    /// The unit direction of view; `None` if the target is where the camera is.
    pub fn direction(&self) -> Option<Vec3> {
        (self.target - self.position).try_normalize()
    }

    /// A direction up in the picture, not along the view: z, or y for a view
    /// along z, turned about the direction of view by the roll, clockwise as the
    /// camera sees it. `None` as [`direction`](Self::direction).
    pub fn up(&self) -> Option<Vec3> {
        let view = self.direction()?;
        let upright = if view.x == 0.0 && view.y == 0.0 { Vec3::Y } else { Vec3::Z };
        let across = view.cross(upright).try_normalize()?;
        let (sine, cosine) = self.roll_degrees.to_radians().sin_cos();
        Some(across.cross(view) * cosine + across * sine)
    }
}

/// Reads a camera chunk (4700). `None` if it stands nowhere.
pub(super) fn decode(
    name: String,
    mut reader: Reader<'_>,
    warnings: &mut Warnings,
) -> Option<Camera> {
    let place = reader.vec3().zip(reader.vec3()).filter(|(p, t)| p.is_finite() && t.is_finite());
    let Some((position, target)) = place else {
        warnings.add(WarningKind::CameraWithoutPlace);
        return None;
    };
    let [roll_degrees, lens] = reader.finite(warnings).unwrap_or([0.0; 2]);
    let flags = ObjectFlags::default();
    let mut camera = Camera { name, flags, position, target, roll_degrees, lens, ranges: None };
    while let Some((id, mut body)) = reader.next_chunk(warnings) {
        if id == 0x4720 {
            camera.ranges = body.finite(warnings);
        }
    }
    Some(camera)
}

#[cfg(test)]
mod tests {
    use super::super::tests::writer::{chunk, floats};
    use super::*;

    fn decoded(numbers: &[f32], rest: &[u8]) -> (Option<Camera>, Warnings) {
        let mut warnings = Warnings::default();
        let bytes = [floats(numbers), rest.to_vec()].concat();
        (decode("eye".to_string(), Reader::new(&bytes), &mut warnings), warnings)
    }

    #[test]
    fn a_camera_with_all_it_has() {
        let ranges = chunk(0x4720, &[&floats(&[0.5, 80.0])]);
        let (camera, _) = decoded(&[1.0, 2.0, 3.0, 1.0, 7.0, 3.0, 90.0, 48.0], &ranges);
        let camera = camera.unwrap();
        assert_eq!((camera.name.as_str(), camera.ranges), ("eye", Some([0.5, 80.0])));
        assert_eq!((camera.fov_degrees(), camera.direction()), (50.0, Some(Vec3::Y)));
        // Rolled clockwise by a quarter, the top of the picture is where right was.
        assert!((camera.up().unwrap() - Vec3::X).length() < 1e-6);
    }

    #[test]
    fn up_is_never_along_the_view() {
        let up = |target: [f32; 3]| {
            let [x, y, z] = target;
            decoded(&[0.0, 0.0, 0.0, x, y, z, 0.0, 50.0], &[]).0.unwrap().up()
        };
        assert_eq!(up([0.0, 0.0, -5.0]), Some(Vec3::Y));
        assert_eq!(up([0.0, 4.0, 0.0]), Some(Vec3::Z));
        assert_eq!(up([0.0; 3]), None);
    }

    #[test]
    fn lenses_that_cannot_be() {
        let fov = |lens| {
            decoded(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, lens], &[]).0.unwrap().fov_degrees()
        };
        assert_eq!([fov(0.0), fov(-3.0), fov(f32::NAN), fov(1.0)], [45.0, 45.0, 45.0, 179.0]);
        assert!((fov(53.333_33) - 45.0).abs() < 1e-4);
    }

    #[test]
    fn a_camera_nowhere_is_dropped() {
        for numbers in [&[0.0, 0.0, 0.0, 1.0, 0.0][..], &[f32::NAN, 0.0, 0.0, 1.0, 0.0, 0.0]] {
            let (camera, warnings) = decoded(numbers, &[]);
            assert_eq!((camera, warnings.count(&WarningKind::CameraWithoutPlace)), (None, 1));
        }
    }
}
