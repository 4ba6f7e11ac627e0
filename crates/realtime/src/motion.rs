//! Motions of a camera. All lengths are in proportion to its distance from the target, so that a
//! scene and one of twice its size are walked through alike.

use std::f64::consts::PI;
use traylib_math::glam::DVec3;
use traylib_math::{Vec2, Vec3};
use traylib_scene::CameraSettings;

/// One step of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion {
    /// Around the target: to the right and up, in radians.
    Orbit(Vec2),
    /// The head: to the right and up, in radians.
    Look(Vec2),
    /// Along the picture: to the right and up, in widths of it at the target.
    Pan(Vec2),
    /// To the right, up and forward, in distances of the target.
    Walk(Vec3),
    /// Toward the target: so many natural logarithms of the distance; never beyond it.
    Approach(f32),
}

/// No nearer to the zenith than this, in radians: straight up there is no right.
const ZENITH: f64 = 0.01;

/// The camera after a step.
pub(crate) fn moved(camera: CameraSettings, motion: Motion) -> CameraSettings {
    let Frame { position, target, view, right, up, distance } = Frame::of(&camera);
    let shift = |by: DVec3| CameraSettings {
        position: (position + by).as_vec3(),
        target: (target + by).as_vec3(),
        ..camera
    };
    match motion {
        // The eye goes to the right when what it looks along turns left.
        Motion::Orbit(by) => {
            let offset = turned(-view, up, Vec2::new(by.x, by.y));
            CameraSettings { position: (target + offset).as_vec3(), ..camera }
        }
        Motion::Look(by) => {
            let view = turned(view, up, Vec2::new(-by.x, by.y));
            CameraSettings { target: (position + view).as_vec3(), ..camera }
        }
        Motion::Pan(by) => {
            let by = by.as_dvec2();
            let width = 2.0 * distance * (0.5 * f64::from(camera.fov_degrees).to_radians()).tan();
            let upward = right.cross(view / distance);
            shift(width * (by.x * right + by.y * upward))
        }
        Motion::Walk(by) => {
            let by = by.as_dvec3();
            shift(distance * (by.x * right + by.y * up) + by.z * view)
        }
        Motion::Approach(by) => {
            let offset = -view * f64::from(-by).exp();
            CameraSettings { position: (target + offset).as_vec3(), ..camera }
        }
    }
}

/// Returns the camera of the same picture with its target at this distance.
pub(crate) fn aimed_at(camera: CameraSettings, distance: f32) -> CameraSettings {
    let Frame { position, view, .. } = Frame::of(&camera);
    let target = position + view.normalize() * f64::from(distance);
    CameraSettings { target: target.as_vec3(), ..camera }
}

/// The measures of a camera's steps.
struct Frame {
    position: DVec3,
    target: DVec3,
    /// From one to the other.
    view: DVec3,
    /// Unit vector.
    right: DVec3,
    /// Unit vector: up in the world, not in the picture.
    up: DVec3,
    distance: f64,
}

impl Frame {
    fn of(camera: &CameraSettings) -> Self {
        let [position, target, up] =
            [camera.position, camera.target, camera.up].map(Vec3::as_dvec3);
        let view = target - position;
        let right = view.cross(up).normalize();
        Self { position, target, view, right, up: up.normalize(), distance: view.length() }
    }
}

/// A vector turned counter-clockwise around `up` and toward it, short of the zenith.
fn turned(vector: DVec3, up: DVec3, by: Vec2) -> DVec3 {
    let by = by.as_dvec2();
    let along = vector.dot(up);
    let level = vector - along * up;
    let (length, reach) = (vector.length(), level.length());
    let azimuth = (level * by.x.cos() + up.cross(level) * by.x.sin()) / reach;
    let from_zenith = (reach.atan2(along) - by.y).clamp(ZENITH, PI - ZENITH);
    length * (from_zenith.sin() * azimuth + from_zenith.cos() * up)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::FRAC_PI_2;
    use traylib_scene::Camera;

    /// At (0, 0, 4), looking at the origin.
    fn camera() -> CameraSettings {
        CameraSettings {
            position: 4.0 * Vec3::Z,
            target: Vec3::ZERO,
            up: Vec3::Y,
            fov_degrees: 90.0,
            width: 40,
            height: 30,
        }
    }

    fn all() -> [Motion; 5] {
        let by = Vec2::new(0.3, -0.2);
        [
            Motion::Orbit(by),
            Motion::Look(by),
            Motion::Pan(by),
            Motion::Walk(Vec3::new(0.1, 0.2, 0.3)),
            Motion::Approach(0.5),
        ]
    }

    fn assert_at(found: Vec3, wanted: [f32; 3]) {
        assert!((found - Vec3::from(wanted)).length() < 1e-5, "{found} is not {wanted:?}");
    }

    #[test]
    fn each_step_goes_where_its_name_says() {
        let of = |motion| moved(camera(), motion);
        let quarter = Vec2::new(FRAC_PI_2, 0.0);
        assert_at(of(Motion::Orbit(quarter)).position, [4.0, 0.0, 0.0]);
        assert_at(
            of(Motion::Orbit(Vec2::new(0.0, 0.5))).position,
            [0.0, 4.0 * 0.5_f32.sin(), 4.0 * 0.5_f32.cos()],
        );
        assert_at(of(Motion::Look(quarter)).target, [4.0, 0.0, 4.0]);
        assert_at(
            of(Motion::Look(Vec2::new(0.0, 0.5))).target,
            [0.0, 4.0 * 0.5_f32.sin(), 4.0 - 4.0 * 0.5_f32.cos()],
        );
        // A picture of 90° is eight wide at a distance of four.
        assert_at(of(Motion::Pan(Vec2::new(0.5, 0.25))).position, [4.0, 2.0, 4.0]);
        assert_at(of(Motion::Walk(Vec3::new(0.5, 0.25, 0.5))).position, [2.0, 1.0, 2.0]);
        assert_at(of(Motion::Walk(Vec3::new(0.5, 0.25, 0.5))).target, [2.0, 1.0, -2.0]);
        assert_at(of(Motion::Approach(2.0_f32.ln())).position, [0.0, 0.0, 2.0]);
    }

    #[test]
    fn nothing_goes_over_the_zenith() {
        for by in [100.0, -100.0] {
            for motion in [Motion::Orbit(Vec2::new(0.1, by)), Motion::Look(Vec2::new(0.1, by))] {
                let camera = moved(moved(camera(), motion), motion);
                assert!(Camera::new(camera).is_ok(), "{motion:?}");
            }
        }
    }

    #[test]
    fn a_step_back_undoes_a_step() {
        for motion in all() {
            let back = match motion {
                Motion::Orbit(by) => Motion::Orbit(-by),
                Motion::Look(by) => Motion::Look(-by),
                Motion::Pan(by) => Motion::Pan(-by),
                Motion::Walk(by) => Motion::Walk(-by),
                Motion::Approach(by) => Motion::Approach(-by),
            };
            let found = moved(moved(camera(), motion), back);
            assert_at(found.position, camera().position.to_array());
            assert_at(found.target, camera().target.to_array());
        }
    }

    #[test]
    fn scenes_of_all_sizes_are_walked_through_alike() {
        let scaled = |camera: CameraSettings, by: f32| CameraSettings {
            position: by * camera.position,
            target: by * camera.target,
            ..camera
        };
        for motion in all() {
            for by in [0.125, 1024.0] {
                assert_eq!(
                    moved(scaled(camera(), by), motion),
                    scaled(moved(camera(), motion), by)
                );
            }
        }
    }

    #[test]
    fn a_nearer_target_leaves_the_view() {
        let camera = CameraSettings { target: Vec3::new(1.0, 1.0, 3.0), ..camera() };
        let near = aimed_at(camera, 0.5);
        assert_at(
            (near.target - near.position).normalize(),
            (camera.target - camera.position).normalize().to_array(),
        );
        assert!(((near.target - near.position).length() - 0.5).abs() < 1e-6);
    }
}
