//! The program as people run it, on scenes small enough for a test.

#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod parts;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use traylib_compare::results::Results;

/// A folder of one test, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("traylib-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// Names of the files in a folder of it, in order.
    fn files(&self, folder: &str) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.join(folder)).unwrap();
        let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name();
        let mut names: Vec<String> =
            entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn text(&self, file: &str) -> String {
        std::fs::read_to_string(self.0.join(file)).unwrap()
    }

    fn results(&self) -> Results {
        serde_json::from_str(&self.text("results.json")).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn program(out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_compare-integrators"));
    command.arg("--out").arg(out);
    command
}

/// A plus stands for a blank within a word.
fn compare(out: &Path, words: &str) -> Output {
    let words = words.split_whitespace().map(|word| word.replace('+', " "));
    program(out).args(words).output().unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

const SMALL: &str =
    "--resolution 16x12 --budgets 0.004s,0.008s --seeds 4 --methods puremc,directlight+--combine";

/// A closed form, so no reference has to be rendered.
#[test]
fn all_that_is_promised_lies_there() {
    let out = Folder::new("compare");
    let output = compare(&out.0, &format!("furnace {SMALL}"));
    assert!(output.status.success(), "{}", err(&output));
    let results = out.results();
    let scene = &results.scenes[0];
    assert!(results.complete && results.oracle.is_none());
    assert_eq!((scene.width, scene.height, scene.methods.len()), (16, 12, 2));
    assert!(scene.reference.origin.contains("closed form"));
    // In a furnace of reflectance ½ the noise is that of a number of bounces.
    for method in &scene.methods {
        assert!(method.metrics.bias.abs() < 0.2, "{:?}", method.metrics);
        assert!(method.points.iter().all(|point| point.solid));
        assert!(method.rays.camera >= 192.0 && method.peak_bytes > 0);
    }
    let csv = std::fs::read_to_string(out.0.join("results.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 2 * 4);
    let page = std::fs::read_to_string(out.0.join("index.html")).unwrap();
    assert!(page.contains(&scene.verdict.sentence));
    assert!(out.text("furnace-error.svg").contains("\ndirectlight --combine\n"));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told.contains(&scene.verdict.sentence) && told.contains("index.html"), "{told}");
}

/// Finished runs are not done again: all are found, so even their times stay.
#[test]
fn a_second_time_goes_on_from_the_first() {
    let out = Folder::new("again");
    let words = format!("furnace {SMALL}");
    assert!(compare(&out.0, &words).status.success());
    let first = out.results();
    assert!(compare(&out.0, &words).status.success());
    assert_eq!(out.results().scenes[0].methods, first.scenes[0].methods);
    let other = format!("{words} --first-seed 100");
    assert!(compare(&out.0, &other).status.success());
    assert_ne!(out.results().scenes[0].methods, first.scenes[0].methods);
}

/// The reference is rendered by the first and found by the second, and what was held
/// against it is found all the same.
#[test]
fn two_methods_make_a_reference_that_finds_its_runs_again() {
    let out = Folder::new("pair");
    let words = format!("reference-a {SMALL},bdpt --quick");
    let kept = || ["references", "runs"].map(|folder| out.files(folder));
    let output = compare(&out.0, &words);
    assert!(output.status.success(), "{}", err(&output));
    let first = (out.results().scenes, kept());
    // A choice and two references with two pictures each; 3 methods with 4 runs of one picture.
    assert_eq!(first.1.each_ref().map(Vec::len), [1 + 2 * 3, 3 * 4 * 2]);
    assert!(compare(&out.0, &words).status.success());
    let second = (out.results().scenes, kept());
    assert_eq!(second.1, first.1);
    assert_eq!(second.0[0].methods, first.0[0].methods);
    assert_eq!(second.0[0].reference, first.0[0].reference);
    let reference = &out.results().scenes[0].reference;
    let agreement = reference.agreement.as_ref().unwrap();
    assert_eq!(agreement.methods[0], "bdpt");
    assert!(agreement.tiles > 0 && reference.own_error > 0.0);
    let lengths = &out.results().scenes[0].lengths;
    let light: f64 = lengths.iter().map(|length| length.light).sum();
    assert!((light - 1.0).abs() < 1e-9 && lengths.len() > 5, "{lengths:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_keeps_what_is_done() {
    let out = Folder::new("interrupt");
    let words = "furnace --resolution 16x12 --budgets 0.02s --seeds 500 --methods puremc";
    let mut child = program(&out.0).args(words.split_whitespace()).spawn().unwrap();
    let runs = out.0.join("runs");
    let done = || std::fs::read_dir(&runs).map_or(0, Iterator::count);
    while done() < 20 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let results = out.results();
    assert!(!results.complete && results.scenes[0].methods.len() == 1);
    assert!(std::fs::read_to_string(out.0.join("index.html")).unwrap().contains("nterrupted"));
}

#[test]
fn pictures_from_elsewhere_stand_on_the_chart_and_under_it() {
    let out = Folder::new("outside");
    let picture = out.0.join("mine.exr");
    let exr = traylib_math::Grid::filled(16, 12, traylib_math::Rgb::splat(2.2));
    let info = traylib_io::PictureInfo {
        exposure: 1.0,
        tone: traylib_io::Tone::Linear,
        program: String::new(),
        integrator: String::new(),
        command: String::new(),
        scene: "plates".into(),
        seed: 0,
        spp: 1,
        frame: None,
        rejected_samples: 0,
    };
    traylib_io::save_picture(&picture, &exr, &info).unwrap();
    let list = out.0.join("list.json");
    let text = r#"[{"scene": "furnace", "name": "mine", "seconds": 3, "picture": "mine.exr"}]"#;
    std::fs::write(&list, text).unwrap();
    let outside = format!("furnace {SMALL} --outside {}", list.display());
    let output = compare(&out.0, &outside);
    assert!(output.status.success(), "{}", err(&output));
    let told = "mine.exr: says that it shows `plates`, not `furnace`";
    assert_eq!(err(&output).matches(told).count(), 1, "{}", err(&output));
    let point = &out.results().scenes[0].outside[0];
    let expected = 0.04 / 4.04;
    assert!((point.error / expected - 1.0).abs() < 1e-5 && point.seconds == 3.0, "{point:?}");
    // Before any work is done.
    let refused = Folder::new("outside-size");
    let output = compare(&refused.0, &outside.replace("16x12", "8x8"));
    assert_eq!(output.status.code(), Some(3), "{}", err(&output));
    assert!(!refused.0.join("runs").exists());
    let given = format!("furnace {SMALL} --reference {}", picture.display());
    let output = compare(&out.0, &given);
    assert!(output.status.success() && err(&output).contains(told), "{}", err(&output));
    let bias = out.results().scenes[0].methods[0].metrics.bias;
    assert!((bias + 0.09).abs() < 0.1, "{bias}");
    let wrong = given.replace("16x12", "8x8");
    let output = compare(&out.0, &wrong);
    assert_eq!(output.status.code(), Some(3), "{}", err(&output));
}

/// A lamp behind the camera in empty space.
const DARK: &str = "(
    camera: (position: (0, 0, 0), target: (0, 0, -1), fov: 60, resolution: (16, 12)),
    materials: { \"wall\": Lambert(reflectance: (0.5, 0.5, 0.5)) },
    objects: [
        (shape: Sphere(center: (0, 0, 9), radius: 1), material: \"wall\", emission: (1, 1, 1)),
    ],
)";

#[test]
fn without_light_there_is_no_verdict() {
    let out = Folder::new("dark");
    let file = out.0.join("dark.ron");
    std::fs::write(&file, DARK).unwrap();
    let output = compare(&out.0, &format!("{} {SMALL},bdpt --quick", file.display()));
    assert!(output.status.success(), "{}", err(&output));
    let scene = &out.results().scenes[0];
    assert_eq!((scene.verdict.best.as_ref(), scene.methods.len()), (None, 0));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    for text in [told, std::fs::read_to_string(out.0.join("index.html")).unwrap()] {
        assert!(text.contains("Nothing can be compared: the reference is black ("), "{text}");
        assert!(!text.contains("times as long"), "{text}");
        assert!(!text.contains("ratio of their means is"), "{text}");
    }
}

#[test]
fn mistakes_are_told_in_a_line() {
    let out = Folder::new("mistakes");
    let list = out.0.join("list.json");
    let text = r#"[{"scene": "furnaze", "name": "n", "seconds": 3, "picture": "mine.exr"}]"#;
    std::fs::write(&list, text).unwrap();
    let unknown = format!("furnace --outside {}", list.display());
    for (words, code, text) in [
        ("no-such-scene", 3, "no-such-scene"),
        ("furnace --methods pt", 2, "pt"),
        ("furnace --methods bdpt:no-connections", 2, "is spelled `bdpt --no-connections` now"),
        ("furnace cornell --reference a.exr", 2, "--reference"),
        ("furnace --reference no-such.exr", 3, "no-such.exr"),
        ("furnace --outside no-such.json", 3, "no-such.json"),
        (&unknown, 2, "`furnaze`, which is not compared; compared: `furnace`"),
    ] {
        let output = compare(&out.0, words);

        assert_eq!(output.status.code(), Some(code), "{words}: {}", err(&output));
        assert!(err(&output).contains(text), "{words}: {}", err(&output));
        assert!(!out.0.join("index.html").exists());
        let lines = err(&output).lines().filter(|line| !line.starts_with("warning: this")).count();
        assert!(words != unknown || lines == 1, "{}", err(&output));
    }
}

/// A signal as soon as a reference is being made: no scene is done, and what an earlier
/// comparison left stays as it is.
#[cfg(unix)]
#[test]
fn nothing_done_replaces_nothing() {
    let out = Folder::new("early");
    assert!(compare(&out.0, &format!("furnace {SMALL}")).status.success());
    let left = || ["index.html", "results.json", "results.csv"].map(|n| out.text(n));
    let before = left();
    let words = "cornell --resolution 16x12 --budgets 60s --methods puremc";
    let mut child = program(&out.0);
    let child = child.args(words.split_whitespace()).stderr(std::process::Stdio::piped());
    let mut child = child.spawn().unwrap();
    let mut told = std::io::BufReader::new(child.stderr.take().unwrap());
    let mut line = String::new();
    while !line.starts_with("cornell") {
        line.clear();
        assert!(std::io::BufRead::read_line(&mut told, &mut line).unwrap() > 0);
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-TERM", &id]).status().unwrap().success());
    let rest = std::io::read_to_string(told).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(143), "{rest}");
    assert!(rest.contains("told to terminate before any scene was done"), "{rest}");
    assert!(!rest.contains("interrupt"), "{rest}");
    assert_eq!(left(), before);
}

#[test]
fn results_of_other_scenes_are_replaced_with_a_word() {
    let out = Folder::new("replaced");
    let first = compare(&out.0, &format!("furnace {SMALL}"));
    assert!(first.status.success() && !err(&first).contains("replaced"), "{}", err(&first));
    let again = compare(&out.0, &format!("furnace {SMALL}"));
    assert!(again.status.success() && !err(&again).contains("replaced"), "{}", err(&again));
    let file = out.0.join("dark.ron");
    std::fs::write(&file, DARK).unwrap();
    let other = compare(&out.0, &format!("{} {SMALL} --quick", file.display()));
    assert!(err(&other).contains("the results of furnace there are replaced"), "{}", err(&other));
    // No run was made, and those of the furnace are not of this page.
    assert!(!out.0.join("results.csv").exists());
}

/// Scenes of one name, and scenes for which no method is left, are refused before any work.
#[test]
fn names_and_methods_that_do_not_fit_are_told_at_once() {
    let out = Folder::new("fit");
    let files = ["a", "b"].map(|folder| out.0.join(folder).join("room.ron"));
    for file in &files {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, DARK).unwrap();
    }
    let [a, b] = files.map(|file| file.display().to_string());
    for (words, texts) in [
        (format!("{a} {b}"), [a.as_str(), b.as_str(), "called `room`"]),
        ("furnace furnace".into(), ["`furnace` and `furnace`", "called", "furnace"]),
        ("furnace --methods trace".into(), ["furnace: trace", "no point lights", "nobody else"]),
    ] {
        let output = compare(&out.0, &words);
        assert_eq!(output.status.code(), Some(2), "{words}: {}", err(&output));
        assert!(texts.iter().all(|text| err(&output).contains(text)), "{}", err(&output));
        assert!(!out.0.join("runs").exists());
    }
    let output = compare(&out.0, &format!("furnace {SMALL},trace"));
    assert!(output.status.success(), "{}", err(&output));
    let told = "warning: furnace: trace left out: the scene has no point lights";
    assert!(err(&output).contains(told), "{}", err(&output));
}
