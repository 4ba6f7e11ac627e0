//! Options of where the picture is taken from.

use crate::outcome::Failure;
use clap::Args;
use traylib_io::ron_scene::{self, CameraChange};
use traylib_scene::{Camera, CameraSettings, Scene};

/// The camera that takes the picture, if it is not the scene's own.
#[derive(Args, Clone, Debug, Default)]
pub struct CameraOptions {
    /// Take the picture from elsewhere: what stands in a scene file's `camera`, all or some of
    /// it, as `realtime` prints it: 'position: (0, 1, 4), fov: 40'
    #[arg(long, value_name = "CAMERA", value_parser = CameraChange::read)]
    pub camera: Option<CameraChange>,

    /// Change one value of the camera: camera.fov=35, camera.position=(0,1,4); may be repeated
    #[arg(short = 'D', value_name = "KEY=VALUE", value_parser = read_definition)]
    pub definitions: Vec<CameraChange>,
}

impl CameraOptions {
    /// The scene as these options want it seen; `resolution` is that of the command line, which
    /// counts for more than that of a camera.
    ///
    /// # Errors
    /// It makes no camera.
    pub(crate) fn applied_to(
        &self,
        scene: Scene,
        resolution: Option<(u32, u32)>,
    ) -> Result<Scene, Failure> {
        if !self.is_there() {
            return Ok(scene);
        }
        let mut settings = scene.camera().settings();
        for change in self.camera.iter().chain(&self.definitions) {
            settings = change.applied_to(settings);
        }
        if let Some((width, height)) = resolution {
            settings = CameraSettings { width, height, ..settings };
        }
        let camera = Camera::new(settings);
        let camera = camera.map_err(|error| Failure::usage(format_args!("--camera: {error}")))?;
        Ok(scene.seen_by(camera))
    }

    /// The options that give this camera, if any did.
    pub(crate) fn words(&self, settings: &CameraSettings) -> Option<String> {
        self.is_there().then(|| ron_scene::Camera::of(settings).to_string())
    }

    fn is_there(&self) -> bool {
        self.camera.is_some() || !self.definitions.is_empty()
    }
}

/// Reads `camera.fov=35`.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
fn read_definition(text: &str) -> Result<CameraChange, String> {
    let field = text.strip_prefix("camera.").and_then(|rest| rest.split_once('='));
    let (field, value) =
        field.ok_or("wanted as camera.fov=35; other values are in the scene's file")?;
    CameraChange::read(&format!("{field}: {value}"))
}
