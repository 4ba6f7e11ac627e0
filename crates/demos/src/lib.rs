//! What the demo programs have in common: options, loading, progress, saving
//! and the words of every message. Each program names its integrator and its own
//! options, and nothing more. `film` renders nothing: it looks into pictures and
//! compares them ([`FilmCommand`]).

mod bug;
mod command_line;
mod duration;
mod film;
mod interrupt;
mod memory;
mod messages;
mod options;
mod outcome;
mod progress;
mod run;
mod signals;
mod stats;
mod technique_pictures;

pub use command_line::parse;
pub use duration::parse_duration;
pub use film::{ConvertOptions, DiffOptions, FilmCommand, InfoOptions};
pub use interrupt::on_interrupt;
pub use messages::{print_notes, say, tell, tell_name};
pub use options::{
    HeuristicName, PathOptions, PixelName, RenderOptions, parse_resolution, parse_threads,
};
pub use outcome::Failure;
pub use progress::clock;
pub use run::{Done, Job, conclude, run};
pub use signals::Signal;
pub use technique_pictures::save_techniques;

/// The examples that end a program's long help.
#[macro_export]
macro_rules! examples {
    ($program:literal) => {
        concat!(
            "Examples:\n",
            "  ",
            $program,
            "                                  the built-in scene `cornell`\n",
            "  ",
            $program,
            " pyramid --spp 256 -o out.exr     a built-in scene, linear radiance\n",
            "  ",
            $program,
            " my.ron --time-limit 5m           a file, for five minutes",
        )
    };
}
