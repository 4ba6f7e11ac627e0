//! Scenes of any format, written anew.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{SceneCommand, parse};

const EXAMPLES: &str = "\
Examples:
  scene convert kitchen.xml kitchen.ron     meshes and pictures go to kitchen-files
  scene convert office.mgf office.ron
  scene convert cornell mine.ron            a built-in scene, to begin with

The scene file that is written has every shape by itself and materials as they
are rendered; it reads back as the same scene, and renders to the same picture.
A file without any light gets a point light at the camera.

Ends with 0, 2 if the command line was not understood, 3 if the scene cannot be
read or makes no sense, 4 if the result cannot be written or is there already.";

/// Writes scenes of other formats as scene files in RON, to go on by hand
#[derive(Parser)]
#[command(
    name = "scene",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = EXAMPLES
)]
struct Options {
    #[command(subcommand)]
    command: SceneCommand,
}

fn main() -> ExitCode {
    parse::<Options>().command.run()
}
