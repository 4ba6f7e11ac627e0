//! What people read: results on standard output, all else on standard error. No
//! reader is no reason to stop.

use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::run::Done;
use std::fmt::Display;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::Path;
use traylib_integrators::{Integrator, Limits, SceneFacts};
use traylib_io::{Loaded, printable, printable_json};
use traylib_scene::Scene;

/// Prints something about the work, as text that does nothing to a terminal.
pub fn say(text: impl Display) {
    let _ = writeln!(std::io::stderr(), "{}", printable(&text.to_string()));
}

/// Prints a warning or a note, which is one line whatever a file has put into it.
pub(crate) fn say_line(kind: &str, text: impl Display) {
    say(format_args!("{kind}: {}", text.to_string().replace('\n', "\\n")));
}

/// Prints one line of the program's result, as text that does nothing to a terminal.
///
/// # Errors
/// Standard output takes no more.
pub fn tell(line: impl Display) -> Result<(), Failure> {
    print(&printable(&line.to_string()))
}

/// [`tell`] for JSON.
///
/// # Errors
/// As `tell`.
pub(crate) fn tell_json(json: &str) -> Result<(), Failure> {
    print(&printable_json(json))
}

/// Prints the name of a file that was written: as it is for whoever reads it to find the
/// file, as [`tell`] for people.
///
/// # Errors
/// As `tell`.
pub fn tell_name(file: &Path) -> Result<(), Failure> {
    let name = file.display();
    if std::io::stdout().is_terminal() { tell(name) } else { print(&name.to_string()) }
}

fn print(text: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{text}") {
        // A reader that has seen enough closes the pipe.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::output(format_args!("standard output: cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints the text that an integrator was asked for: a program's result.
///
/// # Errors
/// Standard output takes no more, as a file on a full disk.
pub fn print_notes(done: &Done) -> Result<(), Failure> {
    done.notes.iter().try_for_each(tell)
}

/// What to know before the start.
pub(crate) fn announce(
    program: &str,
    loaded: &Loaded,
    integrator: &dyn Integrator,
    limits: Limits,
) {
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
    let points = scene.lights().iter().filter(|light| light.is_point()).count();
    format!(
        "{name}: {}, {}, {}, {}, {}x{} pixels",
        counted(scene.primitive_count(), "primitive"),
        counted(scene.materials().len(), "material"),
        counted(scene.lights().len() - points, "area lamp"),
        counted(points, "point light"),
        camera.width(),
        camera.height(),
    )
}

/// What was done, and why it ended.
pub(crate) fn summarise(program: &str, done: &Done, end: &str) {
    let Done { passes, error, statistics, .. } = done;
    let (name, seconds) = (&done.loaded.name, done.elapsed.as_secs_f64());
    let error = match error {
        Some(error) => format!("estimated error {:.2} %", 100.0 * error),
        None => String::from("error unknown"),
    };
    say(format_args!("{program} {name}: {passes} spp in {seconds:.2} s, {error}; ended by {end}"));
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
    let rejected = statistics.rejected;
    if rejected > 0 {
        say(format_args!(
            "warning: {rejected} samples were negative or not finite and were left out; please report the scene"
        ));
    } else {
        say("  non-finite samples: 0");
    }
}

/// A number short enough to read.
pub(crate) fn count(n: u64) -> String {
    match n as f64 {
        x if x >= 1e9 => format!("{:.2} G", x / 1e9),
        x if x >= 1e6 => format!("{:.2} M", x / 1e6),
        x if x >= 1e4 => format!("{:.1} k", x / 1e3),
        _ => n.to_string(),
    }
}

/// A number of things, one or several.
fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}

/// What to try next, for those who started a program without any option.
pub(crate) fn suggest(options: &RenderOptions) {
    if std::env::args_os().len() == 1 {
        say(format_args!(
            "next: try another scene, as `-- pyramid --time-limit 30s`, or `-- --help` (this was {})",
            options.scene
        ));
    }
}
