//! Bidirectional path tracing.

use clap::Parser;
use std::path::PathBuf;
use std::process::ExitCode;
use traylib_demos::{
    Failure, HeuristicName, Job, PathOptions, PixelName, RenderOptions, parse, print_notes, run,
    save_techniques,
};
use traylib_integrators::{Bdpt, Report, Weighting};

/// Bidirectional path tracing: all ways to join walks from both ends, weighted
#[derive(Parser)]
#[command(
    name = "bdpt",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = traylib_demos::examples!("bdpt")
)]
struct Options {
    #[command(flatten)]
    render: RenderOptions,
    #[command(flatten)]
    paths: PathOptions,
    /// How densities become weights
    #[arg(long, value_enum, default_value_t)]
    heuristic: HeuristicName,
    /// Compute weights by summing over all techniques: slow, for comparison
    #[arg(long)]
    direct_sum: bool,
    /// Also write a picture of each technique (s, t), raw and weighted, into a
    /// folder
    #[arg(long, value_name = "DIR")]
    techniques: Option<PathBuf>,
    /// Print the paths that add to a pixel, counted from 0,0 at the top left,
    /// with densities and weights; writes no picture
    ///
    /// A path of s vertices from the lamp and t from the camera begins with its
    /// `value`, the red, green and blue radiance that its technique alone would add to
    /// the pixel, and the `weight` that this is multiplied by. Then come its vertices
    /// from the lamp to the camera: `F` is the density, per area of the scene, of
    /// finding the vertex by a walk from the lamp, `B` by one from the camera, 0 where
    /// no walk can; `weight of s=i` is that of the technique with i vertices from the
    /// lamp, and all of a path add up to 1.
    #[arg(long, value_name = "X,Y", conflicts_with_all = ["techniques", "outfile"])]
    pixel: Option<PixelName>,
}

impl Options {
    /// Pictures of techniques. Of paths of more than ten edges there are so few that most of
    /// their pictures is never touched.
    fn layers(&self) -> u64 {
        if self.techniques.is_none() {
            return 0;
        }
        let longest = u64::from(self.paths.max_depth.unwrap_or(10).min(10));
        // Paths of k edges have k + 1 techniques, each with two pictures.
        longest * (longest + 3)
    }

    fn own_words(&self) -> String {
        let direct_sum = if self.direct_sum { " --direct-sum" } else { "" };
        format!("--heuristic {}{direct_sum}", self.heuristic)
    }
}

fn main() -> ExitCode {
    let options: Options = parse();
    let job = Job {
        wants_picture: options.pixel.is_none(),
        folder: options.techniques.as_deref(),
        layers: options.layers(),
        own_options: options.own_words(),
        ..Job::new("bdpt", &options.render, Some(&options.paths))
    };
    let weighting = if options.direct_sum { Weighting::DirectSum } else { Weighting::Recursive };
    run(
        &job,
        |scene, limits| {
            let report = match (&options.techniques, options.pixel) {
                (Some(_), _) => Report::Techniques,
                (None, Some(pixel)) => Report::Pixel(pixel.index_in(scene.camera())?),
                (None, None) => Report::None,
            };
            let heuristic = options.heuristic.into();
            Ok(Bdpt { limits, heuristic, weighting, report, ..Bdpt::default() })
        },
        |done| -> Result<(), Failure> {
            print_notes(&done.rendering)?;
            job.folder.map_or(Ok(()), |folder| save_techniques(folder, &job, done))
        },
    )
}
