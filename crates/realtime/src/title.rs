//! The title of the window.

use crate::frame::Frame;
use std::time::Duration;
use traylib_demos::count;
use traylib_integrators::Statistics;

/// The rates at which frames and rays come.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rates {
    frames: u64,
    rays: u64,
    seconds: f64,
    /// The work on the picture that is being refined which has been counted.
    counted: (Statistics, f64),
}

impl Rates {
    /// Counts a frame: all of its work, or if it refines the last one what was added.
    pub(crate) fn add(&mut self, frame: &Frame) {
        let (done, since) = self.counted;
        let refines = frame.coarseness == 1 && frame.passes > 1 && frame.seconds >= since;
        let (done, since) = if refines { (done.rays(), since) } else { (0, 0.0) };
        self.frames += 1;
        self.rays += frame.statistics.rays().saturating_sub(done);
        self.seconds += frame.seconds - since;
        self.counted = (frame.statistics, frame.seconds);
    }

    /// Frames and rays in a second of drawing, of what was counted since this was asked last;
    /// `None` if that is nothing.
    pub(crate) fn take(&mut self) -> Option<[f64; 2]> {
        let Self { frames, rays, seconds, .. } = *self;
        (self.frames, self.rays, self.seconds) = (0, 0, 0.0);
        (seconds > 0.0).then(|| [frames as f64, rays as f64].map(|number| number / seconds))
    }
}

/// Scene and method, how fast frames come, and how good the last one is.
pub(crate) fn title(scene: &str, frame: &Frame, [frames, rays]: [f64; 2]) -> String {
    let method = match frame.wanted.method.auto() {
        Some(_) if frame.coarseness == 1 => format!("auto, {}", frame.method),
        Some(_) | None => frame.method.to_string(),
    };
    let rays = count(rays as u64);
    let error = frame.error.map_or(String::new(), |error| format!(", err {:.2} %", 100.0 * error));
    format!(
        "TrayLib {scene}: {method} | {frames:.0} frames/s, {rays}ray/s | {} spp{error}",
        frame.passes
    )
}

/// The time that one title stays.
pub(crate) const TITLE_TIME: Duration = Duration::from_millis(300);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Wanted;
    use traylib_integrators::Method;
    use traylib_math::{Grid, Rgb, Vec3};
    use traylib_scene::CameraSettings;

    fn frame(passes: u32, rays: u64, seconds: f64) -> Frame {
        let camera = CameraSettings {
            position: Vec3::ZERO,
            target: Vec3::Z,
            up: Vec3::Y,
            fov_degrees: 40.0,
            width: 1,
            height: 1,
        };
        Frame {
            wanted: Wanted { camera, method: Method::COMBINED },
            method: Method::COMBINED,
            coarseness: 1,
            radiance: Grid::filled(1, 1, Rgb::BLACK),
            pixels: vec![0],
            exposure: 1.0,
            passes,
            error: (passes > 1).then_some(0.125),
            statistics: Statistics { camera_rays: rays, ..Statistics::default() },
            seconds,
        }
    }

    #[test]
    fn rates_count_all_work_once() {
        let mut rates = Rates::default();
        assert_eq!(rates.take(), None);
        rates.add(&frame(1, 1000, 0.25));
        rates.add(&frame(3, 3000, 0.75));
        assert_eq!(rates.take(), Some([2.0 / 0.75, 4000.0]));
        // Another picture.
        rates.add(&frame(1, 500, 0.5));
        assert_eq!(rates.take(), Some([2.0, 1000.0]));
    }

    #[test]
    fn a_title_tells_speed_and_error() {
        let told = title("cornell", &frame(7, 1, 1.0), [12.4, 3.25e6]);
        let wanted = "TrayLib cornell: directlight --combine | 12 frames/s, 3.25 Mray/s | 7 spp, err 12.50 %";
        assert_eq!(told, wanted);
        let told = title("cornell", &frame(1, 1, 1.0), [12.4, 3.25e6]);
        assert!(told.ends_with("| 1 spp"), "{told}");
        let mut planned = frame(1, 1, 1.0);
        planned.wanted.method = Method::AUTO;
        let told = title("cornell", &planned, [12.4, 3.25e6]);
        assert!(told.contains(": auto, directlight --combine |"), "{told}");
        (planned.coarseness, planned.method) = (2, Method::AUTO);
        let told = title("cornell", &planned, [12.4, 3.25e6]);
        assert!(told.contains(": bdpt --auto |"), "{told}");
    }
}
