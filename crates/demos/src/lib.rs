//! The parts that the demo programs have in common: options, loading, progress, saving and the
//! words of every message. Each program names its method and what else it writes, and nothing more.
//! `film` renders nothing: it looks into pictures and compares them ([`FilmCommand`]).

mod aov;
mod aov_layers;
mod auto;
mod black;
mod bug;
mod camera_options;
mod checkpoint;
mod command_line;
mod conclude;
mod denoise;
mod display;
mod done;
mod drive;
mod duration;
mod end;
mod explain;
mod exposure;
mod film;
mod for_shells;
mod interrupt;
mod job;
mod keep_options;
mod memory;
mod messages;
mod noise;
mod options;
mod outcome;
mod outputs;
mod plan;
mod progress;
mod progress_form;
mod recipe;
mod run;
mod run_stats;
mod say;
mod scene;
mod shard;
mod signals;
mod stats;
mod technique_pictures;
mod technique_sheet;
mod window_options;

pub use aov::Aov;
pub use camera_options::CameraOptions;
pub use command_line::{CommandLine, parse};
pub use conclude::conclude;
pub use display::DisplayAddress;
pub use done::Done;
pub use duration::parse_duration;
pub use explain::Explain;
pub use exposure::{Exposure, parse_exposure};
pub use film::{
    ConvertOptions, DenoiseOptions, DiffOptions, FilmCommand, InfoOptions, MergeOptions,
};
pub use interrupt::on_interrupt;
pub use job::Job;
pub use keep_options::KeepOptions;
pub use messages::{announce, print_notes};
pub use noise::Noise;
pub use options::{PixelName, RenderOptions, parse_limit, parse_resolution, parse_threads};
pub use outcome::Failure;
pub use progress::clock;
pub use progress_form::ProgressForm;
pub use recipe::{Recipe, with_spp};
pub use run::{render_by, run};
pub use say::{count, say, tell, tell_name};
pub use scene::{SceneCommand, SceneConvertOptions};
pub use shard::Shard;
pub use signals::Signal;
pub use technique_pictures::save_techniques;
pub use window_options::{Crop, PixelBounds, WindowOptions};

/// The version of the programs, with the commit if they were built in a checkout:
/// `0.1.0 (ec3c1fe01234)`.
pub const VERSION: &str = env!("TRAYLIB_VERSION");

/// The examples that end a program's long help.
fn examples(program: &str) -> String {
    let scene = "the built-in scene `cornell`";
    let blanks = " ".repeat(34);
    format!(
        "\
Examples:
  {program}{blanks}{scene}
  {program} pyramid --spp 256 -o out.exr     a built-in scene, linear radiance
  {program} my.ron --time-limit 5m           a file, for five minutes

The estimated error, `err` while it renders, is the root of the mean variance of
a pixel, as far as its passes tell, over the mean radiance. Light that no path
finds is not in it.

Pictures in .png and .exr say how they were made, as a command; `film info`
prints it.

{}

Ends with 0, 2 if the command line was not understood, 3 if a scene cannot be
read or makes no sense, 4 if the picture cannot be written, does not fit into
memory or the time was up in the first pass, 5 if --noise was not reached, 6 if a checkpoint is of another
rendering, 130 after Ctrl-C, 143 if it was
told to terminate, 129 if the terminal was closed. The second time Ctrl-C ends
at once.",
        for_shells::HELP
    )
}
