//! The program, as its users meet it: without a display, and in a window of a display that
//! nobody sees, where there is one (Xvfb, xdotool and xdpyinfo must be installed).
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]
#![allow(clippy::print_stderr, reason = "what is left out is told")]

mod screen;

use screen::{Screen, wait};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;
use traylib_integrators::{Method, Settings, render_to_end};
use traylib_io::{
    LoadOptions, Loaded, PictureInfo, TextureLimits, load_scene, load_scene_with, load_texture,
    save_picture,
};

/// A new folder, removed with all that is in it when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("traylib-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_realtime"));
        command.current_dir(&self.0).args(arguments.split_whitespace());
        command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        command
    }

    fn run(&self, arguments: &str) -> (Option<i32>, String, String) {
        let Output { status, stdout, stderr } = self.command(arguments).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (status.code(), text(stdout), text(stderr))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn without_a_display_one_line_says_so() {
    let (status, out, err) = Folder::new("no-display").run("");
    assert_eq!((status, out.as_str()), (Some(4), ""), "{err}");
    assert!(
        err.starts_with("error: no window can be opened: ") && err.contains("--frames"),
        "{err}"
    );
    assert_eq!(err.lines().count(), 1, "{err}");
}

#[test]
fn what_is_wrong_is_said_before_there_is_a_window() {
    let folder = Folder::new("wrong");
    for (arguments, wanted, word) in [
        ("no-such-scene", 3, "no-such-scene"),
        ("--method bdpd", 2, "bdpd"),
        ("--outfile a.doc", 2, "a.doc"),
        ("--outfile no-such-folder/a.png", 4, "no-such-folder"),
        ("--frames 0", 2, "--frames"),
    ] {
        let (status, out, err) = folder.run(arguments);
        assert_eq!((status, out.as_str()), (Some(wanted), ""), "{arguments}: {err}");
        assert!(err.contains(word), "{arguments}: {err}");
    }
}

#[test]
fn speed_is_measured_without_a_window() {
    let folder = Folder::new("frames");
    let (status, out, err) = folder.run("--frames 3 --resolution 40x30 --method puremc -q cornell");
    assert_eq!((status, err.as_str()), (Some(0), ""), "{out}");
    assert!(
        out.starts_with("cornell 40x30 puremc: 3 frames in ") && out.ends_with("ray/s\n"),
        "{out}"
    );
    assert_eq!(std::fs::read_dir(&folder.0).unwrap().count(), 0);
}

#[test]
fn help_tells_the_keys_and_three_examples() {
    let (status, out, _) = Folder::new("help").run("--help");
    assert_eq!(status, Some(0));
    assert!(["Examples:", "F12", "--frames 100", "Home"].iter().all(|word| out.contains(word)));
    assert!(out.lines().all(|line| line.chars().count() <= 80), "{out}");
}

/// A program that does not outlive its test.
struct Running(Child);

impl Running {
    /// Waits for its end.
    fn end(mut self) -> (Option<i32>, String, String) {
        let status = wait(|| self.0.try_wait().unwrap());
        let [out, err] = self.read();
        (status.code(), out, err)
    }

    /// Returns the text that it has printed until its end.
    fn read(&mut self) -> [String; 2] {
        let [mut out, mut err] = [String::new(), String::new()];
        self.0.stdout.take().unwrap().read_to_string(&mut out).unwrap();
        self.0.stderr.take().unwrap().read_to_string(&mut err).unwrap();
        [out, err]
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A file holds what the program of the method makes of a scene with so many samples.
fn assert_is_picture(file: &Path, loaded: &Loaded, method: Method, spp: u32) {
    let settings = Settings { spp, ..Settings::default() };
    let rendering = render_to_end(&loaded.scene, &*method.build(), &settings).unwrap();
    let info = PictureInfo { exposure: loaded.settings.exposure, ..PictureInfo::default() };
    let wanted = file.with_extension("wanted.png");
    save_picture(&wanted, &rendering.film.develop(), &info).unwrap();
    let pixels = |file| load_texture(file, TextureLimits::default()).unwrap().pixels;
    assert!(pixels(file) == pixels(&wanted), "{}", file.display());
}

/// Opens, draws, obeys mouse and keys, ends with 0; pictures are those of the programs.
#[test]
fn a_window_obeys_mouse_and_keys() {
    let folder = Folder::new("window");
    let screen = match Screen::open() {
        Ok(screen) => screen,
        Err(lack) => return eprintln!("left out: {lack}"),
    };
    let mut command = folder.command("cornell --method bdpt --spp 2 --resolution 120x90");
    command.env("DISPLAY", screen.name()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut program = Running(command.spawn().unwrap());
    let window = wait(|| {
        assert!(program.0.try_wait().unwrap().is_none(), "{:?}", program.read());
        screen.window("TrayLib cornell")
    });
    screen.point_at(&window, (60, 45));
    let file = |name: &str| folder.0.join(name);

    // As the scene has it.
    wait(|| screen.title(&window).contains(": bdpt |").then_some(()));
    wait(|| screen.title(&window).contains("| 2 spp").then_some(()));
    screen.key("F12");
    wait(|| file("realtime.png").is_file().then_some(()));
    screen.key("p");
    // Another method, from another place.
    screen.key("1");
    screen.drag(&window, (60, 45), (80, 50));
    screen.hold("w");
    screen.key("p");
    wait(|| screen.title(&window).contains(": trace |").then_some(()));
    screen.key("F12");
    wait(|| file("realtime-2.png").is_file().then_some(()));
    // Another size, and home.
    screen.resize(&window, (64, 48));
    screen.point_at(&window, (30, 20));
    screen.key("Home");
    std::thread::sleep(Duration::from_millis(300));
    screen.key("p");
    screen.key("Escape");
    let (status, out, err) = program.end();
    assert_eq!(status, Some(0), "{out}{err}");

    let lines: Vec<&str> = out.lines().collect();
    let [first, home, away, second, back] = lines[..] else { panic!("{out}") };
    assert_eq!([first, second], ["realtime.png", "realtime-2.png"]);
    assert!(home.contains("resolution: (120, 90)") && back.contains("resolution: (64, 48)"));
    assert_eq!(home.replace("(120, 90)", "(64, 48)"), back);
    assert_ne!(home, away);

    let load = LoadOptions { resolution: Some((120, 90)), ..LoadOptions::default() };
    let same = load_scene_with("cornell", load).unwrap();
    assert_is_picture(&file("realtime.png"), &same, Method::BDPT, 2);
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.ron"));
    let text = text.unwrap();
    let old = text.lines().find(|line| line.trim_start().starts_with("camera:")).unwrap();
    std::fs::write(file("away.ron"), text.replace(old, away)).unwrap();
    let moved = load_scene(file("away.ron").to_str().unwrap()).unwrap();
    assert_is_picture(&file("realtime-2.png"), &moved, Method::TRACE, 1);
}
