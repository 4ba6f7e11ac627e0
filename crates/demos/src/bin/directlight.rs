//! Path tracing with lamps sampled at every vertex.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{HeuristicName, Job, PathOptions, RenderOptions, parse, run};
use traylib_integrators::DirectLight;

/// Path tracing that aims at a lamp from every vertex
///
/// A lamp that the path hits by itself counts only where no lamp could have been
/// aimed at: seen directly, or after a perfect mirror. With --combine both count
/// everywhere, weighted.
#[derive(Parser)]
#[command(
    name = "directlight",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = traylib_demos::examples!("directlight")
)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
    #[command(flatten)]
    paths: PathOptions,
    /// Combine aimed and chance hits by multiple importance sampling
    #[arg(long)]
    combine: bool,
    /// How densities become weights, with --combine
    #[arg(long, value_enum, default_value_t)]
    heuristic: HeuristicName,
}

fn main() -> ExitCode {
    let options: Options = parse();
    let own_options = if options.combine {
        format!("--combine --heuristic {}", options.heuristic)
    } else {
        String::new()
    };
    let job = Job { own_options, ..Job::new("directlight", &options.render, Some(&options.paths)) };
    let combine = options.combine.then_some(options.heuristic.into());
    run(&job, |_, limits| Ok(DirectLight { limits, combine }), |_| Ok(()))
}
