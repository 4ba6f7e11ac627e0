//! `cargo xtask needs`.

use clap::Parser;
use std::process::ExitCode;
use traylib_compare::needs::{Effort, needs, table};
use traylib_demos::{Failure, conclude, parse, parse_resolution, parse_threads, say, tell};
use traylib_io::{LoadOptions, load_scene_with};

/// What a scene needs: takes one part at a time away from bidirectional tracing, and pictures,
/// bump maps and smooth normals from its surfaces, and tables what that saves in time and costs in
/// error and light
#[derive(Parser, Clone, Debug)]
#[command(
    name = "cargo xtask needs",
    bin_name = "cargo xtask needs",
    version = traylib_demos::VERSION,
    max_term_width = 80
)]
struct Options {
    /// Scene file or name of a built-in scene
    #[arg(default_value = "cornell")]
    scene: String,

    /// Size of the pictures in pixels
    #[arg(long, value_name = "WxH", default_value = "96x72", value_parser = parse_resolution)]
    resolution: (u32, u32),

    /// Samples per pixel of each picture
    #[arg(long, value_name = "N", default_value_t = 16,
        value_parser = clap::value_parser!(u32).range(1..))]
    spp: u32,

    /// Pictures of each, which tell the noise
    #[arg(long, value_name = "N", default_value_t = 8,
        value_parser = clap::value_parser!(u32).range(2..))]
    pictures: u32,

    /// Threads, up to 1024, 0 for one a processor
    #[arg(short, long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    threads: usize,
}

fn main() -> ExitCode {
    let options: Options = parse();
    conclude("needs", || run(&options))
}

fn run(options: &Options) -> Result<(), Failure> {
    if cfg!(debug_assertions) {
        say("warning: this is a debug build, whose times mean nothing; use cargo xtask");
    }
    let load = LoadOptions { resolution: Some(options.resolution), ..LoadOptions::default() };
    let loaded = load_scene_with(&options.scene, load)?;
    let Options { pictures, spp, threads, .. } = *options;
    let effort = Effort { pictures, spp, threads };
    let found = needs(&loaded.scene, effort, &|part| say(format_args!("  {part}")));
    table(&loaded.name, &found?).lines().try_for_each(tell)
}
