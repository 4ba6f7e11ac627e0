//! One ray a pixel, light from point lamps.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{Job, RenderOptions, parse, run};
use traylib_integrators::Trace;
use traylib_io::Headlight;

/// One ray a pixel with a shadow ray to each point lamp; no interreflection
#[derive(Parser)]
#[command(
    name = "trace",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = traylib_demos::examples!("trace")
)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
}

fn main() -> ExitCode {
    let options: Options = parse();
    let job = Job {
        default_spp: Some(1),
        headlight: Headlight::WithoutPointLight,
        ..Job::new("trace", &options.render, None)
    };
    let jitter = options.render.time_limit.is_some() || options.render.spp.unwrap_or(1) > 1;
    run(&job, |_, _| Ok(Trace { jitter }), |_| Ok(()))
}
