//! Being stopped, and readers that go away.

use crate::common::{Folder, Run};
use std::io::{BufRead, BufReader};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use traylib_io::load_exr;

const ENDLESS: &str = "cornell --resolution 32x24 --time-limit 1h -o a.exr";

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
    for signal in ["INT", "TERM", "HUP"] {
        let folder = Folder::new();
        let mut child = start(&folder);
        // The note on long paths is the last line before the work.
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        assert!(lines.any(|line| line.unwrap().starts_with("note: paths")), "{signal}");
        std::thread::sleep(Duration::from_millis(200));
        send(signal, &child);
        let err: Vec<String> = lines.map(Result::unwrap).collect();
        let run = Run::from(child.wait_with_output().unwrap());
        assert_eq!((run.status, run.out.as_str()), (Some(130), "a.exr\n"), "{signal}: {err:?}");
        assert!(err.iter().any(|line| line.ends_with("ended by interrupt")), "{err:?}");
        assert!(err.last().unwrap().starts_with("error: interrupted; what is written has "));
        assert_eq!(folder.names(), ["a.exr"]);
        assert_eq!(load_exr(&folder.path().join("a.exr")).unwrap().height(), 24);
    }
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
fn a_time_limit_holds_within_a_pass() {
    let folder = Folder::new();
    let start = Instant::now();
    let run = folder.run("bdpt", "cornell --resolution 32x24 --time-limit 1s -o a.exr");
    let seconds = start.elapsed().as_secs_f64();
    assert_eq!(run.status, Some(0), "{}", run.err);
    // A pass takes milliseconds; the rest is for a machine with other work.
    assert!((1.0..10.0).contains(&seconds), "{seconds}");
}
