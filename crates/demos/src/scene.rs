//! The program `scene`: scenes of any format, written as scene files in RON.

use crate::conclude::conclude;
use crate::options::parse_limit;
use crate::outcome::Failure;
use crate::say::{say_line, tell_name};
use clap::{Args, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;
use traylib_io::{Limit, LoadOptions, ReadLimits, convert_scene};

/// What to do with scenes.
#[derive(Subcommand, Clone, Debug)]
pub enum SceneCommand {
    /// Write a scene in RON, with meshes and pictures in a folder beside it
    Convert(SceneConvertOptions),
}

/// A scene to write anew.
#[derive(Args, Clone, Debug)]
pub struct SceneConvertOptions {
    /// Scene file (.ron, .gltf, .glb, .obj, .ply, .3ds, .mgf, Mitsuba's .xml) or name of a
    /// built-in scene
    #[arg(value_name = "IN")]
    pub input: String,

    /// Scene to write, NAME.ron; its meshes and pictures go to NAME-files
    #[arg(value_name = "OUT")]
    pub output: PathBuf,

    /// Replace what is there already
    #[arg(long)]
    pub force: bool,

    /// The folder that files included by a scene or MGF file may come from
    /// [default: that of the scene]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Allow more of what files may ask for, as a message names it, as surfaces=2M; may be
    /// repeated
    #[arg(long, value_name = "NAME=N", value_parser = parse_limit)]
    pub limit: Vec<(Limit, u64)>,
}

impl SceneCommand {
    /// Does it. Ends the program's `main`: prints what went wrong and returns the
    /// exit status.
    pub fn run(&self) -> ExitCode {
        conclude("scene", || match self {
            Self::Convert(options) => convert(options),
        })
    }
}

fn convert(options: &SceneConvertOptions) -> Result<(), Failure> {
    let mut limits = ReadLimits::default();
    options.limit.iter().for_each(|&(limit, value)| limits.set(limit, value));
    let load = LoadOptions { root: options.root.as_deref(), limits, ..LoadOptions::default() };
    let converted = convert_scene(&options.input, &options.output, load, options.force)?;
    for warning in &converted.warnings {
        say_line("warning", warning);
    }
    for note in &converted.notes {
        say_line("note", note);
    }
    converted.files.iter().try_for_each(|file| tell_name(file))
}
