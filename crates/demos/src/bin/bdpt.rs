//! Bidirectional path tracing.

use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;
use traylib_demos::{CommandLine, Explain, Job, PixelName, print_notes, run, save_techniques};
use traylib_integrators::{Method, Report};

/// The reports beside the picture.
#[derive(Args, Clone, Debug)]
struct Reports {
    /// Also write a picture of each technique (s, t), raw and weighted, into a
    /// folder, and sheets of all of them: a row is a length of paths, a column is s
    #[arg(long, value_name = "DIR", conflicts_with = "auto")]
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
    #[arg(long, value_name = "X,Y", conflicts_with_all = ["techniques", "outfile", "auto"])]
    pixel: Option<PixelName>,
    /// Render by this method, as --auto chose it before: `directlight --combine`, say
    #[arg(
        long,
        value_name = "METHOD",
        conflicts_with_all = ["techniques", "pixel", "auto", "max-depth", "roulette", "heuristic",
            "direct-sum", "no-connections", "no-splats", "light-paths", "no-images"]
    )]
    plan: Option<Method>,
    /// With --auto: print what was chosen from, and why
    #[arg(
        long,
        value_name = "FORMAT",
        requires = "auto",
        num_args = 0..=1,
        default_missing_value = "text"
    )]
    explain: Option<Explain>,
}

/// Pictures of techniques. Of paths of more than ten edges there are so few that most of
/// their pictures is never touched.
fn layers(line: &CommandLine<Reports>) -> u64 {
    if line.own.techniques.is_none() {
        return 0;
    }
    let max_depth = line.method.limits().and_then(|limits| limits.max_depth);
    let longest = u64::from(max_depth.unwrap_or(10).min(10));
    // Paths of k edges have k + 1 techniques, each with two pictures.
    longest * (longest + 3)
}

fn main() -> ExitCode {
    let line = CommandLine::<Reports>::parse(Method::BDPT);
    let Reports { techniques, pixel, plan, explain } = &line.own;
    let job = Job {
        wants_picture: pixel.is_none(),
        folder: techniques.as_deref(),
        layers: layers(&line),
        explain: *explain,
        method: Some(plan.unwrap_or(line.method)),
        ..Job::of(&line)
    };
    run(
        &job,
        |job, scene| {
            let report = match (techniques, pixel) {
                (Some(_), _) => Report::Techniques,
                (None, Some(pixel)) => Report::Pixel(pixel.index_in(scene.camera())?),
                (None, None) => Report::None,
            };
            Ok(job.build(report))
        },
        |done| {
            print_notes(done)?;
            job.folder.map_or(Ok(()), |folder| save_techniques(folder, &job, done))
        },
    )
}
