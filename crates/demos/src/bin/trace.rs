//! One ray a pixel, light from point lamps.

use std::process::ExitCode;
use traylib_demos::{CommandLine, Job, RenderOptions, run};
use traylib_integrators::{Method, Report};
use traylib_io::Headlight;

fn main() -> ExitCode {
    let mut line = CommandLine::<()>::parse(Method::TRACE);
    let RenderOptions { time_limit, spp, .. } = line.render;
    if time_limit.is_some() || spp.unwrap_or(1) > 1 {
        line.method = line.method.for_many_samples();
    }
    let job =
        Job { default_spp: Some(1), headlight: Headlight::WithoutPointLight, ..Job::of(&line) };
    run(&job, |job, _| Ok(job.build(Report::None)), |_| Ok(()))
}
