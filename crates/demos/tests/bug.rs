//! A panic is told of in one line and ends with status 1.

use clap::Parser;
use std::process::{Command, ExitCode};
use traylib_demos::{Job, RenderOptions, run};
use traylib_integrators::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use traylib_scene::Scene;

struct Broken;

impl Integrator for Broken {
    fn render_chunk(&self, _: &Scene, _: &Chunk, _: &mut ChunkOutput) {
        panic!("two\nlines");
    }

    fn blind_spots(&self, _: &SceneFacts) -> Vec<BlindSpot> {
        Vec::new()
    }
}

#[derive(Parser)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
}

const INSIDE: &str = "TRAYLIB_TEST_INSIDE";

/// Runs this test again as a program of its own: the hook is the process's.
#[test]
fn a_panic_is_told_of_in_one_line() {
    if let Some(file) = std::env::var_os(INSIDE) {
        let arguments = ["broken", "--resolution", "64x64", "-q", "--threads", "4", "-o"];
        let options = Options::parse_from(arguments.map(Into::into).into_iter().chain([file]));
        let job = Job::new("broken", &options.render);
        let code = run(&job, |_, _| Ok(Box::new(Broken)), |_| Ok(()));
        assert_eq!(format!("{code:?}"), format!("{:?}", ExitCode::from(1)));
        return;
    }
    let file = std::env::temp_dir().join(format!("traylib-bug-{}.png", std::process::id()));
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "a_panic_is_told_of_in_one_line", "--nocapture"])
        .env(INSIDE, &file)
        .env_remove("RUST_BACKTRACE")
        .env_remove("RUST_LIB_BACKTRACE")
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{err}");
    assert_eq!(err.lines().count(), 1, "{err}");
    assert!(err.starts_with("error: this is a bug in broken "), "{err}");
    assert!(err.contains("two lines") && err.contains("please report"), "{err}");
    assert!(!file.exists());
}
