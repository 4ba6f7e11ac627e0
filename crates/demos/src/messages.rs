//! The messages of a rendering program: before the start, at the end.

use crate::done::Done;
use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::say::{count, say, say_line, tell};
use traylib_integrators::{Integrator, Limits, SceneFacts};
use traylib_io::Loaded;
use traylib_scene::{Light, Scene};

/// Prints the text that an integrator was asked for: a program's result.
///
/// # Errors
/// Standard output takes no more, as a file on a full disk.
pub fn print_notes(done: &Done) -> Result<(), Failure> {
    done.notes.iter().try_for_each(tell)
}

/// Says what is to be known before the start: what was amiss or not said in the scene's
/// file, and what this program leaves out of its picture.
pub fn announce(program: &str, loaded: &Loaded, integrator: &dyn Integrator, limits: Limits) {
    for warning in &loaded.warnings {
        say_line("warning", warning);
    }
    for note in &loaded.notes {
        say_line("note", note);
    }
    if cfg!(debug_assertions) {
        say("warning: this is a debug build, many times slower; use cargo run --release");
    }
    for blind in integrator.blind_spots(&SceneFacts::of(&loaded.scene)) {
        say(format_args!("note: {program} cannot produce {blind}"));
    }
    if let Some(edges) = limits.max_depth.map(|edges| edges as usize) {
        let (longest, bounces) = (counted(edges, "edge"), counted(edges - 1, "bounce"));
        let vertices = edges + 1;
        say(format_args!(
            "note: paths of more than {longest} ({bounces}, {vertices} vertices) are left out: the picture is darker for it"
        ));
    }
}

/// One line on what a scene holds.
pub(crate) fn describe(name: &str, scene: &Scene) -> String {
    let camera = scene.camera();
    let number_of =
        |is_one: fn(&Light) -> bool| scene.lights().iter().filter(|&light| is_one(light)).count();
    let sky = if scene.sky().is_some() { ", a sky" } else { "" };
    format!(
        "{name}: {}, {}, {}, {}{sky}, {}x{} pixels",
        counted(scene.primitive_count(), "primitive"),
        counted(scene.materials().len(), "material"),
        counted(number_of(|light| matches!(light, Light::Area { .. })), "area lamp"),
        counted(number_of(Light::is_point), "point light"),
        camera.width(),
        camera.height(),
    )
}

/// Says what was done, and why it ended.
pub(crate) fn summarise(program: &str, done: &Done, end: &str) {
    let Done { passes, error, statistics, .. } = done;
    let (name, seconds) = (&done.loaded.name, done.elapsed.as_secs_f64());
    let error = match error {
        Some(error) => format!("estimated error {:.2} %", 100.0 * error),
        None => String::from("error unknown"),
    };
    let before = match done.before.unwrap_or_default().passes {
        0 => String::new(),
        before => format!(", {before} of them before,"),
    };
    say(format_args!(
        "{program} {name}: {passes} spp{before} in {seconds:.2} s, {error}; ended by {end}"
    ));
    say(format_args!(
        "  rays: {} camera, {} bounce, {} shadow; {} a second",
        count(statistics.camera_rays),
        count(statistics.bounce_rays),
        count(statistics.shadow_rays),
        count((statistics.rays() as f64 / seconds) as u64),
    ));
    say(format_args!(
        "  paths: {} camera, {} light; {} a second",
        count(statistics.camera_paths),
        count(statistics.light_paths),
        count((statistics.camera_paths as f64 / seconds) as u64),
    ));
    let rejected = statistics.rejected + done.before.unwrap_or_default().rejected;
    if rejected > 0 {
        say(format_args!(
            "warning: {rejected} samples were negative or not finite and were left out; please report the scene"
        ));
    } else {
        say("  non-finite samples: 0");
    }
}

/// A number of things, one or several.
fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}

/// Suggests what to try next, to those who started a program without any option.
pub(crate) fn suggest(options: &RenderOptions) {
    if std::env::args_os().len() == 1 {
        say(format_args!(
            "next: try another scene, as `-- pyramid --time-limit 30s`, or `-- --help` (this was {})",
            options.scene
        ));
    }
}
