//! Snapshots: the picture and the camera that are kept of a view.

use crate::frame::Frame;
use crate::options::Options;
use std::path::{Path, PathBuf};
use traylib_demos::{Failure, Recipe, VERSION, tell_name, with_spp};
use traylib_io::{PictureInfo, Tone, ron_scene, save_picture};
use traylib_scene::{CameraSettings, FilmWindow};

/// The camera as a line of a scene file, which reads back as the same.
pub(crate) fn camera_line(camera: &CameraSettings) -> String {
    format!("{},", ron_scene::Camera::of(camera))
}

/// Writes a frame into a file that is not there yet, and tells its name.
///
/// # Errors
/// It cannot be written.
pub(crate) fn write(
    frame: &Frame,
    scene: &str,
    is_moved: bool,
    options: &Options,
) -> Result<(), Failure> {
    let file = free_name(&options.outfile, &mut |file| file.exists());
    save_picture(&file, &frame.radiance, &info(frame, scene, is_moved, options))?;
    tell_name(&file)
}

/// Returns the description of how it was made, with the command that makes it again.
fn info(frame: &Frame, scene: &str, is_moved: bool, options: &Options) -> PictureInfo {
    let (method, camera) = (frame.method, &frame.wanted.camera);
    let recipe = Recipe {
        program: method.name(),
        scene: &options.scene,
        camera: is_moved.then(|| ron_scene::Camera::of(camera).to_string()),
        resolution: (camera.width, camera.height),
        window: FilmWindow::whole(camera.width, camera.height),
        seed: options.seed,
        points: options.sampler,
        exposure: frame.exposure,
        tone: Tone::Linear,
        limits: &options.limit,
        method: Some(method),
    };
    PictureInfo {
        exposure: frame.exposure,
        tone: Tone::Linear,
        program: format!("TrayLib {VERSION}"),
        integrator: method.name().into(),
        command: with_spp(&recipe.command(), frame.passes),
        scene: scene.into(),
        seed: options.seed,
        spp: u64::from(frame.passes),
        rejected_samples: frame.statistics.rejected,
        frame: None,
    }
}

/// `a.png`, or the first of `a-2.png`, `a-3.png` and so on that is free.
fn free_name(file: &Path, is_taken: &mut dyn FnMut(&Path) -> bool) -> PathBuf {
    let numbered = |number: u32| {
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let ending = file.extension().unwrap_or_default().to_string_lossy();
        file.with_file_name(format!("{stem}-{number}.{ending}"))
    };
    let mut names = std::iter::once(file.to_path_buf()).chain((2..).map(numbered));
    names.find(|name| !is_taken(name)).unwrap_or_else(|| file.to_path_buf())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Motion, moved};
    use traylib_integrators::{Method, Settings, render_to_end};
    use traylib_io::load_scene;
    use traylib_math::Vec2;
    use traylib_scene::Camera;

    #[test]
    fn names_are_not_used_twice() {
        let free = |taken: &[&str]| {
            free_name(Path::new("d/a.b.png"), &mut |file| {
                taken.iter().any(|taken| Path::new(taken) == file)
            })
        };
        assert_eq!(free(&[]), Path::new("d/a.b.png"));
        assert_eq!(free(&["d/a.b.png", "d/a.b-2.png"]), Path::new("d/a.b-3.png"));
    }

    /// The line in place of that of a scene file: the same camera, and the same picture.
    #[test]
    fn a_scene_file_reads_the_camera_back() {
        let text = std::fs::read_to_string(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../scenes/spheres.ron"
        ));
        let text = text.unwrap();
        let home = load_scene("spheres").unwrap();
        let turned = moved(
            home.scene.camera().settings(),
            Motion::Orbit(Vec2::new(std::f32::consts::LN_2, 0.1)),
        );
        let turned = CameraSettings { width: 41, height: 29, ..turned };
        let old = text.lines().find(|line| line.trim_start().starts_with("camera:")).unwrap();
        let folder = std::env::temp_dir().join(format!("traylib-camera-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("turned.ron");
        std::fs::write(&file, text.replace(old, &camera_line(&turned))).unwrap();
        let read = load_scene(file.to_str().unwrap()).unwrap().scene;
        std::fs::remove_dir_all(folder).unwrap();
        assert_eq!(read.camera().settings(), turned);
        let seen = home.scene.seen_by(Camera::new(turned).unwrap());
        let picture = |scene| {
            let settings = Settings { spp: 1, ..Settings::default() };
            render_to_end(scene, &*Method::TRACE.build(), &settings).unwrap().film.develop()
        };
        assert_eq!(picture(&read), picture(&seen));
    }
}
