//! How to make a picture again.

use crate::job::Job;
use std::fmt::Write;
use std::path::Path;
use traylib_integrators::Method;
use traylib_io::Loaded;

/// The command that makes a picture again, from the same scene: every option that changes the
/// picture but [`--spp`](with_spp), also those that were not given. Of the scene's file only
/// the name, as folders tell of people.
pub(crate) fn command(job: &Job<'_>, loaded: &Loaded) -> String {
    let options = job.options;
    let scene = Path::new(&options.scene).file_name().map(|name| name.to_string_lossy());
    let camera = loaded.scene.camera();
    let mut command = format!(
        "{} {} --resolution {}x{} --seed {} --sampler {} --exposure {}",
        job.program,
        quoted(&scene.unwrap_or_default()),
        camera.width(),
        camera.height(),
        options.seed,
        options.sampler,
        loaded.settings.exposure,
    );
    for (limit, value) in &options.limit {
        // A string takes everything.
        let _ = write!(command, " --limit {}={value}", limit.name());
    }
    for setting in job.method.into_iter().flat_map(Method::settings) {
        let _ = write!(command, " {setting}");
    }
    command
}

/// A command for so many passes.
pub(crate) fn with_spp(command: &str, passes: u32) -> String {
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
