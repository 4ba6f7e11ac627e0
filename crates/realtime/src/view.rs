//! The view that is wanted: a camera and a method. What was drawn of another view is of no use.

use crate::motion::{Motion, aimed_at, moved};
use traylib_integrators::Method;
use traylib_scene::{Camera, CameraSettings};

/// The camera and the method of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// Seen from here.
    pub(crate) camera: CameraSettings,
    /// Rendered by this.
    pub(crate) method: Method,
}

/// The picture that is wanted now, and how it came about.
#[derive(Clone, Debug)]
pub(crate) struct View {
    home: CameraSettings,
    /// The method of the command line, which its key comes back to.
    given: Method,
    /// The distance, seen from home, of the surface in the middle of the picture, in metres.
    focus: Option<f32>,
    wanted: Wanted,
}

impl View {
    /// From the scene's own camera, with `focus` as the distance of what is in the middle of
    /// the picture.
    pub(crate) fn new(home: CameraSettings, method: Method, focus: Option<f32>) -> Self {
        Self { home, given: method, focus, wanted: Wanted { camera: home, method } }
    }

    /// Returns the picture to draw. If it is what it was, the picture goes on to be refined.
    pub(crate) fn wanted(&self) -> Wanted {
        self.wanted
    }

    /// Moves the camera. A step that leads to where there is no view is not taken.
    pub(crate) fn step(&mut self, motion: Motion) {
        // Turned around is what one sees, not a target that a file may have put anywhere.
        let from = match self.focus {
            Some(distance) if !self.is_moved() => aimed_at(self.wanted.camera, distance),
            Some(_) | None => self.wanted.camera,
        };
        let to = moved(from, motion);
        if Camera::new(to).is_ok() {
            self.wanted.camera = to;
        }
    }

    /// Back to the scene's own camera.
    pub(crate) fn go_home(&mut self) {
        let CameraSettings { width, height, .. } = self.wanted.camera;
        self.wanted.camera = CameraSettings { width, height, ..self.home };
    }

    /// Renders by another method.
    pub(crate) fn render_by(&mut self, method: Method) {
        let kind = |method: Method| (method.name(), method.auto().is_some());
        let is_given = kind(method) == kind(self.given);
        self.wanted.method = if is_given { self.given } else { method };
    }

    /// Fits a window of so many columns and rows.
    pub(crate) fn resize(&mut self, (width, height): (u32, u32)) {
        // A window that is rolled up has none.
        self.wanted.camera.width = width.max(1);
        self.wanted.camera.height = height.max(1);
    }

    /// Tells whether the camera was moved, be it by the window alone.
    pub(crate) fn is_moved(&self) -> bool {
        let CameraSettings { width, height, .. } = self.home;
        CameraSettings { width, height, ..self.wanted.camera } != self.home
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::{Vec2, Vec3};

    fn home() -> CameraSettings {
        CameraSettings {
            position: Vec3::ZERO,
            target: Vec3::Z,
            up: Vec3::Y,
            fov_degrees: 50.0,
            width: 40,
            height: 30,
        }
    }

    #[test]
    fn rest_keeps_the_picture_and_any_change_begins_anew() {
        let mut view = View::new(home(), Method::TRACE, None);
        let first = view.wanted();
        view.resize((40, 30));
        view.render_by(Method::TRACE);
        view.go_home();
        assert_eq!(view.wanted(), first);
        view.resize((80, 0));
        assert_eq!(view.wanted().camera, CameraSettings { width: 80, height: 1, ..home() });
        assert!(!view.is_moved());
        view.step(Motion::Walk(Vec3::Z));
        assert!(view.is_moved());
        view.render_by(Method::BDPT);
        assert_eq!(view.wanted().method, Method::BDPT);
        view.go_home();
        assert_eq!(view.wanted().camera, CameraSettings { width: 80, height: 1, ..home() });
    }

    #[test]
    fn a_key_comes_back_to_the_options_of_the_command_line() {
        let given = Method::BDPT.up_to(Some(3));
        let mut view = View::new(home(), given, None);
        view.render_by(Method::PURE_MC);
        assert_eq!(view.wanted().method, Method::PURE_MC);
        view.render_by(Method::BDPT);
        assert_eq!(view.wanted().method, given);
        view.render_by(Method::AUTO);
        assert_eq!(view.wanted().method, Method::AUTO);
    }

    #[test]
    fn what_is_seen_is_turned_around() {
        let mut view = View::new(home(), Method::TRACE, Some(10.0));
        assert_eq!(view.wanted().camera.target, Vec3::Z);
        view.step(Motion::Orbit(Vec2::new(0.1, 0.0)));
        assert!((view.wanted().camera.target - 10.0 * Vec3::Z).length() < 1e-5);
        // From then on the target stays.
        view.step(Motion::Walk(Vec3::Z));
        let CameraSettings { position, target, .. } = view.wanted().camera;
        assert!(((target - position).length() - 10.0).abs() < 1e-4);
    }

    #[test]
    fn no_step_leads_to_where_there_is_no_view() {
        let mut view = View::new(home(), Method::TRACE, None);
        view.step(Motion::Approach(1e9));
        view.step(Motion::Walk(Vec3::splat(f32::INFINITY)));
        assert_eq!(view.wanted().camera, home());
    }
}
