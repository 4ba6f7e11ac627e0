//! Some of a camera.

use super::Camera;
use serde::Deserialize as Derive;
use traylib_math::Vec3;
use traylib_scene::CameraSettings;

/// The fields that take the place of those of another [`Camera`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Derive)]
#[serde(deny_unknown_fields, default, rename = "Camera")]
pub struct CameraChange {
    position: Option<[f32; 3]>,
    target: Option<[f32; 3]>,
    up: Option<[f32; 3]>,
    fov: Option<f32>,
    resolution: Option<(u32, u32)>,
}

impl CameraChange {
    /// Reads `position: (0, 1, 4), fov: 40`, also as it stands in a scene file, with the word
    /// `camera:`, brackets and a comma behind them.
    ///
    /// # Errors
    /// Returns the fault in words.
    pub fn read(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let text = text.strip_prefix("camera:").unwrap_or(text).trim();
        let text = text.strip_suffix(',').unwrap_or(text).trim();
        let text = if text.starts_with('(') { text.to_owned() } else { format!("({text})") };
        let read = super::options().from_str::<Self>(&text).map_err(|error| error.code.to_string());
        let change =
            read.map_err(|why| format!("{why}; wanted as `position: (0, 1, 4), fov: 40`"))?;
        let width_and_height = change.resolution.unwrap_or((1, 1));
        if crate::MAX_PIXELS < u64::from(width_and_height.0) * u64::from(width_and_height.1) {
            return Err("the picture has too many pixels".into());
        }
        Ok(change)
    }

    /// The camera with this in the place of what it had.
    #[must_use]
    pub fn applied_to(&self, camera: CameraSettings) -> CameraSettings {
        let place = |new: Option<[f32; 3]>, old: Vec3| new.map_or(old, Vec3::from);
        let (width, height) = self.resolution.unwrap_or((camera.width, camera.height));
        CameraSettings {
            position: place(self.position, camera.position),
            target: place(self.target, camera.target),
            up: place(self.up, camera.up),
            fov_degrees: self.fov.unwrap_or(camera.fov_degrees),
            width,
            height,
        }
    }
}

impl Camera {
    /// The camera of these settings.
    pub fn of(settings: &CameraSettings) -> Self {
        Self {
            position: settings.position.to_array(),
            target: settings.target.to_array(),
            up: settings.up.to_array(),
            fov: settings.fov_degrees,
            resolution: (settings.width, settings.height),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_camera_says_of_itself_is_read_again() {
        let settings = CameraSettings {
            position: Vec3::new(0.1, 2.0, -3e-7),
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_degrees: 39.5,
            width: 40,
            height: 30,
        };
        let other = CameraSettings { position: Vec3::ONE, target: Vec3::X, width: 1, ..settings };
        let line = Camera::of(&settings).to_string();
        for text in [line.clone(), format!("{line},"), line.replace("camera: ", "")] {
            assert_eq!(CameraChange::read(&text).unwrap().applied_to(other), settings, "{text}");
        }
        let change = CameraChange::read("fov: 20, target: (1, 2, 3)").unwrap();
        let target = Vec3::new(1.0, 2.0, 3.0);
        assert_eq!(
            change.applied_to(settings),
            CameraSettings { fov_degrees: 20.0, target, ..settings }
        );
    }

    #[test]
    fn what_is_no_camera_is_told() {
        for bad in ["fov", "fov: x", "lens: 3", "position: (1, 2)", "fov: 1, fov: 2", "(fov: 1"] {
            assert!(CameraChange::read(bad).unwrap_err().contains("wanted as"), "{bad}");
        }
        assert!(CameraChange::read("resolution: (99999, 99999)").is_err());
    }
}
