//! A window that shows a scene while one walks through it.

mod bench;
mod draw;
mod frame;
mod input;
mod live;
mod motion;
mod options;
mod painter;
mod plan;
mod screen;
mod snapshot;
mod stage;
mod title;
mod view;
mod window;

use options::Options;
use stage::Stage;
use std::process::ExitCode;
use traylib_demos::{Failure, conclude, parse};

fn main() -> ExitCode {
    let options = parse::<Options>();
    conclude("realtime", || run(&options))
}

fn run(options: &Options) -> Result<(), Failure> {
    let stage = Stage::load(options)?;
    match options.frames {
        Some(frames) => bench::turn(stage, options, frames.get()),
        None => live::show(stage, options),
    }
}
