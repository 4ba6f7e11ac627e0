//! The command that makes a picture again.

use crate::job::Job;
use crate::window_options::PixelBounds;
use std::fmt::Write;
use std::path::Path;
use traylib_integrators::{Method, PointSet};
use traylib_io::{Limit, Loaded, Tone};
use traylib_scene::FilmWindow;

/// The settings that make a picture: all that changes it but how many samples a pixel has.
#[derive(Clone, Debug)]
pub struct Recipe<'a> {
    /// The program that makes it.
    pub program: &'a str,
    /// The scene that the program is told to load.
    pub scene: &'a str,
    /// The camera, where it is not the scene's own.
    pub camera: Option<String>,
    /// Width and height of the frame in pixels.
    pub resolution: (u32, u32),
    /// The part of it that is rendered.
    pub window: FilmWindow,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The source of the random numbers.
    pub points: PointSet,
    /// Factor on light in 8-bit pictures.
    pub exposure: f32,
    /// The curve that follows, there.
    pub tone: Tone,
    /// The bounds on what files may ask for.
    pub limits: &'a [(Limit, u64)],
    /// The method with its settings; `None` for an integrator that is none.
    pub method: Option<Method>,
}

/// The command that makes the picture of a job again, but for its [samples](with_spp).
pub(crate) fn command(job: &Job<'_>, loaded: &Loaded) -> String {
    let options = job.options;
    let camera = loaded.scene.camera();
    let frame = camera.settings();
    let recipe = Recipe {
        program: job.method.map_or(job.program, Method::name),
        scene: &options.scene,
        camera: options.view.words(&frame),
        resolution: (frame.width, frame.height),
        window: camera.window(),
        seed: options.seed,
        points: options.sampler,
        exposure: loaded.settings.exposure,
        tone: options.tone,
        limits: &options.limit,
        method: job.method,
    };
    recipe.command()
}

impl Recipe<'_> {
    /// The command that makes the picture again, from the same scene: every option that
    /// changes it but [`--spp`](with_spp), also those that were not given. Of the scene's file only the name, as
    /// folders tell of people.
    pub fn command(&self) -> String {
        let scene = Path::new(self.scene).file_name().map(|name| name.to_string_lossy());
        let (width, height) = self.resolution;
        let mut command = format!(
            "{} {} --resolution {width}x{height} --seed {} --sampler {} --exposure {}",
            self.program,
            quoted(&scene.unwrap_or_default()),
            self.seed,
            self.points,
            self.exposure,
        );
        // A string takes everything.
        if self.tone != Tone::default() {
            let _ = write!(command, " --tone {}", self.tone);
        }
        if let Some(camera) = &self.camera {
            let _ = write!(command, " --camera {}", quoted(camera));
        }
        if self.window != FilmWindow::whole(width, height) {
            let _ = write!(command, " --pixelbounds {}", PixelBounds::of(self.window));
        }
        for (limit, value) in self.limits {
            let _ = write!(command, " --limit {}={value}", limit.name());
        }
        for setting in self.method.into_iter().flat_map(Method::settings) {
            let _ = write!(command, " {setting}");
        }
        command
    }
}

/// A command for so many passes.
pub fn with_spp(command: &str, passes: u32) -> String {
    format!("{command} --spp {passes}")
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./+=,:@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shell_takes_names_as_they_are() {
        assert_eq!(quoted("a-b.ron"), "a-b.ron");
        assert_eq!(quoted("my room.ron"), "'my room.ron'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
    }
}
