//! The particle tracer.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{Job, PathOptions, RenderOptions, parse, run};
use traylib_integrators::Particle;

/// Particle tracing: walks from the lamps, splatted where the camera sees them
#[derive(Parser)]
#[command(
    name = "particle",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = traylib_demos::examples!("particle")
)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
    #[command(flatten)]
    paths: PathOptions,
}

fn main() -> ExitCode {
    let options: Options = parse();
    let job = Job::new("particle", &options.render, Some(&options.paths));
    run(&job, |_, limits| Ok(Particle { limits }), |_| Ok(()))
}
