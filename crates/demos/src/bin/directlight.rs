//! Path tracing with lamps sampled at every vertex.

use clap::Args;
use std::process::ExitCode;
use traylib_demos::{CommandLine, Job, PixelName, print_notes, run};
use traylib_integrators::{Method, Report};

/// The reports beside the picture.
#[derive(Args, Clone, Debug)]
struct Reports {
    /// Print the paths that add to a pixel, counted from 0,0 at the top left,
    /// with weights; writes no picture
    ///
    /// A path of s vertices from the lamp and t from the camera begins with its
    /// `value`, the red, green and blue radiance that this way of finding it alone would
    /// add to the pixel, and the `weight` that this is multiplied by. Then come its
    /// vertices from the lamp to the camera.
    #[arg(long, value_name = "X,Y", conflicts_with = "outfile")]
    pixel: Option<PixelName>,
}

fn main() -> ExitCode {
    let line = CommandLine::<Reports>::parse(Method::DIRECT_LIGHT);
    let pixel = line.own.pixel;
    let job = Job { wants_picture: pixel.is_none(), ..Job::of(&line) };
    run(
        &job,
        |job, scene| {
            let index = pixel.map(|pixel| pixel.index_in(scene.camera())).transpose()?;
            Ok(job.build(index.map_or(Report::None, Report::Pixel)))
        },
        print_notes,
    )
}
