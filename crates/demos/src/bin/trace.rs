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
    /// Draw the point of a pixel by chance also of one sample, which else goes through
    /// the middle; with more samples or a --time-limit it always is
    #[arg(long)]
    jitter: bool,
}

fn main() -> ExitCode {
    let options: Options = parse();
    let RenderOptions { time_limit, spp, .. } = options.render;
    let jitter = options.jitter || time_limit.is_some() || spp.unwrap_or(1) > 1;
    let job = Job {
        default_spp: Some(1),
        headlight: Headlight::WithoutPointLight,
        own_options: if jitter { "--jitter".into() } else { String::new() },
        ..Job::new("trace", &options.render, None)
    };
    run(&job, |_, _| Ok(Trace { jitter }), |_| Ok(()))
}
