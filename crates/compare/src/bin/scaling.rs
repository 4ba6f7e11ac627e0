//! `cargo xtask scaling`.

use clap::Parser;
use std::path::PathBuf;
use std::process::ExitCode;
use traylib_compare::folder::write_scaling;
use traylib_compare::scaling::{Axis, measure, table};
use traylib_compare::target;
use traylib_demos::{Failure, conclude, parse, say, tell, tell_name};

/// How the time of a sample and memory grow: with triangles, lamps, the length of paths,
/// pixels and threads
///
/// Writes scaling.csv and a chart an axis, and prints a table of each. Beside every time
/// stands the power of size with which it has grown since the line before.
#[derive(Parser, Clone, Debug)]
#[command(
    name = "cargo xtask scaling",
    bin_name = "cargo xtask scaling",
    version = traylib_demos::VERSION,
    max_term_width = 80
)]
struct Options {
    /// What grows [default: all]
    #[arg(value_enum)]
    axes: Vec<Axis>,

    /// No more triangles, lamps, edges, pixels or threads than this
    #[arg(long, value_name = "N", default_value_t = u64::MAX, hide_default_value = true)]
    largest: u64,

    /// Where everything goes [default: target/scaling]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    let options: Options = parse();
    conclude("scaling", || run(&options))
}

fn run(options: &Options) -> Result<(), Failure> {
    if cfg!(debug_assertions) {
        say("warning: this is a debug build, whose times mean nothing; use cargo xtask");
    }
    let axes = if options.axes.is_empty() { &Axis::ALL[..] } else { &options.axes };
    let told = |axis: Axis, size| say(format_args!("{size} {}", axis.name()));
    let scaling = measure(axes, options.largest, told).map_err(Failure::output)?;
    let folder = options.out.clone().unwrap_or_else(|| target().join("scaling"));
    write_scaling(&folder, &scaling).map_err(Failure::output)?;
    tell(table(&scaling).trim_end())?;
    tell_name(&folder.join("scaling.csv"))
}
