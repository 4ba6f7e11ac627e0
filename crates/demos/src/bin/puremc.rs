//! Pure Monte Carlo path tracing.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{Job, PathOptions, RenderOptions, parse, run};
use traylib_integrators::PureMc;

/// Pure Monte Carlo path tracing: walks from the camera until a lamp is hit
#[derive(Parser)]
#[command(
    name = "puremc",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = traylib_demos::examples!("puremc")
)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
    #[command(flatten)]
    paths: PathOptions,
}

fn main() -> ExitCode {
    let options: Options = parse();
    let job = Job::new("puremc", &options.render, Some(&options.paths));
    run(&job, |_, limits| Ok(PureMc { limits }), |_| Ok(()))
}
