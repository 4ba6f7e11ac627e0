//! Being stopped, and readers that go away.

use crate::common::{Folder, Run};
use std::io::{BufRead, BufReader, Write};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use traylib_io::load_exr;

const ENDLESS: &str = "cornell --resolution 32x24 --time-limit 1h -o a.exr";

/// A room in which nothing takes light away, of so many pixels that a pass is not done in a minute.
const WHITE_ROOM: &str = r#"(
    camera: (position: (0, 0, 2), target: (0, 0, 0), fov: 60, resolution: (2000, 2000)),
    materials: { "white": Lambert(reflectance: (1, 1, 1)) },
    objects: [
        (shape: Box(min: (-3, -3, -3), max: (3, 3, 3)), material: "white"),
        (shape: Sphere(center: (0, 0, 0), radius: 0.5), material: "white", emission: (1, 1, 1)),
    ],
)
"#;

/// Starts a program that says on standard error when it is about to begin.
fn start(folder: &Folder) -> Child {
    let options = format!("{ENDLESS} --max-depth 5");
    let mut command = folder.command("puremc", &options);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn send(signal: &str, child: &Child) {
    let status = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status();
    assert!(status.unwrap().success());
}

#[test]
fn signals_end_a_run_with_a_whole_picture() {
    for (signal, status, word) in
        [("INT", 130, "interrupt"), ("TERM", 143, "SIGTERM"), ("HUP", 129, "SIGHUP")]
    {
        let folder = Folder::new();
        let mut child = start(&folder);
        // The note on long paths is the last line before the work.
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        assert!(lines.any(|line| line.unwrap().starts_with("note: paths")), "{signal}");
        std::thread::sleep(Duration::from_millis(200));
        send(signal, &child);
        let err: Vec<String> = lines.map(Result::unwrap).collect();
        let run = Run::from(child.wait_with_output().unwrap());
        assert_eq!((run.status, run.out.as_str()), (Some(status), "a.exr\n"), "{signal}: {err:?}");
        let answer = format!("{word}: ending with the passes that are done");
        assert!(err[0].starts_with(&answer), "{err:?}");
        let end = format!("ended by {word}");
        assert!(err.iter().any(|line| line.ends_with(&end)), "{err:?}");
        assert!(err.last().unwrap().starts_with("error: interrupted; what is written has "));
        assert_eq!(folder.names(), ["a.exr"]);
        assert_eq!(load_exr(&folder.path().join("a.exr")).unwrap().height(), 24);
    }
}

/// The first pass would take minutes. Within half a second, and the rest for a machine
/// with other work.
#[test]
fn what_ends_a_run_is_heard_within_a_pass() {
    let folder = Folder::new();
    folder.write("white.ron", WHITE_ROOM);
    for program in ["puremc", "directlight", "particle", "bdpt"] {
        let start = Instant::now();
        let run = folder.run(program, "./white.ron --time-limit 1s -q -o a.exr");
        assert!(start.elapsed() < Duration::from_secs(10), "{program}");
        assert_eq!((run.status, run.out.as_str()), (Some(4), ""), "{program}");
        let words = "error: the time was up while the first pass was done to 0 %; nothing is written; a smaller --resolution or a longer --time-limit may help\n";
        assert_eq!(run.err, words, "{program}");
        assert_eq!(folder.names(), ["white.ron"]);
    }
}

#[test]
fn signals_are_heard_within_a_pass() {
    let folder = Folder::new();
    folder.write("white.ron", WHITE_ROOM);
    for (signal, status, word, program) in [
        ("INT", 130, "interrupt", "bdpt"),
        ("TERM", 143, "SIGTERM", "puremc"),
        ("HUP", 129, "SIGHUP", "particle"),
    ] {
        let mut command = folder.command(program, "./white.ron --max-depth 100000 -o a.exr");
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        assert!(lines.any(|line| line.unwrap().starts_with("note: paths")), "{signal}");
        std::thread::sleep(Duration::from_millis(300));
        let start = Instant::now();
        send(signal, &child);
        let err: Vec<String> = lines.map(Result::unwrap).collect();
        let run = Run::from(child.wait_with_output().unwrap());
        assert!(start.elapsed() < Duration::from_secs(10), "{signal}");
        assert_eq!((run.status, run.out.as_str()), (Some(status), ""), "{signal}: {err:?}");
        assert_eq!(
            err,
            [
                format!("{word}: ending with the passes that are done; once more stops at once"),
                "error: interrupted while the first pass was done to 0 %; nothing is written"
                    .into(),
            ]
        );
        assert_eq!(folder.names(), ["white.ron"]);
    }
}

/// The program has written its picture and waits for somebody to read its name.
#[test]
fn a_second_interrupt_stops_at_once() {
    let folder = Folder::new();
    let (reader, mut full) = std::io::pipe().unwrap();
    // As many bytes as a pipe holds.
    full.write_all(&vec![b'.'; 1 << 16]).unwrap();
    let mut command = folder.command("bdpt", "cornell --resolution 8x6 --spp 1 -o a.exr");
    let mut child = command.stdout(full).stderr(Stdio::piped()).spawn().unwrap();
    while !folder.path().join("a.exr").exists() {
        std::thread::sleep(Duration::from_millis(10));
    }
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
    send("INT", &child);
    assert!(lines.any(|line| line.unwrap().starts_with("interrupt: ")));
    assert_eq!(child.try_wait().unwrap(), None);
    send("INT", &child);
    let err: Vec<String> = lines.map(Result::unwrap).collect();
    assert_eq!(err, ["error: interrupted again; stopped at once"]);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(reader);
}

/// Nobody writes the scene into its pipe.
#[test]
fn before_the_work_the_first_interrupt_stops_at_once() {
    let folder = Folder::new();
    let (pipe, _writer) = std::io::pipe().unwrap();
    for (signal, status) in [("INT", 130), ("TERM", 143)] {
        let mut command = folder.command("film", "convert /dev/stdin a.png");
        command.stdin(pipe.try_clone().unwrap()).stderr(Stdio::piped());
        let child = command.stdout(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(500));
        send(signal, &child);
        let run = Run::from(child.wait_with_output().unwrap());
        assert_eq!(run.err, "error: interrupted; stopped at once\n");
        assert_eq!((run.status, folder.names()), (Some(status), Vec::new()));
    }
}

/// A hangup that is ignored from the start stays so, as under `nohup`.
#[test]
#[cfg(target_os = "linux")]
fn what_is_ignored_from_the_start_stays_so() {
    let folder = Folder::new();
    let program = env!("CARGO_BIN_EXE_puremc");
    let script = format!("trap '' HUP; exec {program} {ENDLESS} --max-depth 5");
    let mut command = Command::new("sh");
    command.current_dir(folder.path()).args(["-c", &script]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
    assert!(lines.any(|line| line.unwrap().starts_with("note: paths")));
    send("HUP", &child);
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(child.try_wait().unwrap(), None);
    send("TERM", &child);
    assert_eq!((lines.count(), child.wait().unwrap().code()).1, Some(143));
}

#[test]
fn nobody_reading_is_no_reason_to_fail() {
    let folder = Folder::new();
    let options = "cornell --resolution 32x24 --spp 2 -o a.exr";
    let mut child = folder.command("bdpt", options);
    let mut child = child.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop((child.stdout.take(), child.stderr.take()));
    let status = child.wait().unwrap();
    assert_eq!((status.code(), status.signal()), (Some(0), None));
    assert_eq!(folder.names(), ["a.exr"]);
    assert_eq!(load_exr(&folder.path().join("a.exr")).unwrap().width(), 32);
    let mut paths = folder.command("bdpt", "cornell --resolution 8x6 --pixel 3,3 --spp 200 -q");
    let mut paths = paths.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(paths.stdout.take());
    let run = Run::from(paths.wait_with_output().unwrap());
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
}

#[test]
#[cfg(target_os = "linux")]
fn results_that_cannot_be_kept_are_an_error() {
    let folder = Folder::new();
    let full = std::fs::File::create("/dev/full").unwrap();
    let mut command = folder.command("bdpt", "cornell --resolution 8x6 --spp 1 -q");
    let run = Run::from(command.stdout(full).output().unwrap());
    assert_eq!(run.status, Some(4));
    assert!(run.err.starts_with("error: standard output: cannot be written: "), "{}", run.err);
}

#[test]
fn a_time_limit_ends_a_run_between_passes() {
    let folder = Folder::new();
    let start = Instant::now();
    let run = folder.run("bdpt", "cornell --resolution 32x24 --time-limit 1s -o a.exr");
    let seconds = start.elapsed().as_secs_f64();
    assert_eq!(run.status, Some(0), "{}", run.err);
    // A pass takes milliseconds; the rest is for a machine with other work.
    assert!((1.0..10.0).contains(&seconds), "{seconds}");
}
