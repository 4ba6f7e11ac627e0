//! `cargo xtask costs`.

use clap::Parser;
use std::process::ExitCode;
use traylib_compare::costs::{Sample, fit, measure};
use traylib_demos::{Failure, conclude, parse, say, tell};
use traylib_integrators::{Engine, planner::growth};
use traylib_io::{LoadOptions, load_scene_with};

/// The table of prices by which plans count: every method's work on scenes, timed on one
/// thread, and the prices that fit it best
///
/// Wants a machine that does nothing else. The last lines are what
/// crates/integrators/src/planner/cost.rs has.
#[derive(Parser, Clone, Debug)]
#[command(
    name = "cargo xtask costs",
    bin_name = "cargo xtask costs",
    version = traylib_demos::VERSION,
    max_term_width = 80
)]
struct Options {
    /// Scenes, built-in ones or files
    #[arg(default_values = ["cornell", "pyramid", "plates", "reference-a", "reference-c",
        "office-lamps", "small-light", "glass", "hangar"])]
    scenes: Vec<String>,
}

fn main() -> ExitCode {
    let options: Options = parse();
    conclude("costs", || run(&options))
}

fn run(options: &Options) -> Result<(), Failure> {
    if cfg!(debug_assertions) {
        say("warning: this is a debug build, whose times mean nothing; use cargo xtask");
    }
    let mut samples = Vec::new();
    for name in &options.scenes {
        let load = LoadOptions { resolution: Some((64, 64)), ..LoadOptions::default() };
        let loaded = load_scene_with(name, load)?;
        say(&loaded.name);
        samples.extend(measure(&loaded.name, &loaded.scene).map_err(Failure::output)?);
    }
    samples.iter().try_for_each(|sample| tell(line(sample)))?;
    tell("\nengine         sample  camera: bounce  shadow   light: path  bounce  shadow   error")?;
    for engine in Engine::ALL {
        let ([sample, bounce, shadow, path, light, splat], error) = fit(&samples, engine, growth);
        tell(format_args!(
            "{:<12} {sample:>8.0} {bounce:>15.0} {shadow:>7.0} {path:>13.0} {light:>7.0} {splat:>7.0} {:>6.0} %",
            format!("{engine:?}"),
            100.0 * error
        ))?;
    }
    Ok(())
}

fn line(sample: &Sample) -> String {
    let Sample { scene, primitives, method, work, nanoseconds } = sample;
    format!(
        "{scene:<14} {primitives:>7} {nanoseconds:>8.0} ns  {:>6.2} {:>6.2} {:>6.2} {:>6.2} {:>6.2}  {method}",
        work.camera_bounces,
        work.camera_shadows,
        work.light_paths,
        work.light_bounces,
        work.light_shadows,
    )
}
