//! The project's own tasks: `cargo xtask TASK`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

mod book;
mod charts;
mod check_data;
mod ci;
mod count_instructions;
#[cfg(unix)]
mod engines;
mod faults;
mod layers;
mod package;
mod proofs;
mod prove;
mod relations;
mod release;
mod sha256;
mod stability;
mod task;
mod workspace;

use std::process::ExitCode;
use task::Task;

const HELP: &str = "\
The project's own tasks.

Usage: cargo xtask TASK [ARGUMENTS]

  check-data DIR
           what the readers make of the files in DIR/3ds, DIR/mgf, DIR/textures
           and DIR/pictures against the expected.json of each
  layers   hold the dependencies of every crate against the table of layers
  prove    every proof at length, with a report of all claims; under 40 minutes
  faults [--only FAULT…]
           fault injection: put mistakes into a copy of the sources, awaken one at
           a time, and name the tests that find each
  faults --quick [FAULT…]
           the same, but no test program is run after the first that finds a fault
  faults --edit FAULT
           a copy of the sources with this fault alone, as far as its patch applies,
           to mend it or to make a new one
  faults --save FAULT [WHAT IS WRONG]
           write the fault's patch from that copy
  relations [OPTIONS]
           scenes drawn by chance, and relations that must hold on them; under
           40 minutes, --help for more
  stability [OPTIONS]
           every method over every failure scene, judged; --help for more
  compare-integrators [SCENE…] [OPTIONS]
           which method reaches which error in which time; --help for more
  needs [SCENE] [OPTIONS]
           what a scene needs of bidirectional tracing: one part at a time is taken
           away; --help for more
  scaling [WHAT GROWS…] [OPTIONS]
           how time and memory grow with triangles, lamps, the length of paths,
           pixels and threads; --help for more
  costs [SCENE…]
           the table of prices by which `bdpt --auto` counts, made anew
  count-instructions [PART…] [OPTIONS]
           instructions a ray and a triangle, by valgrind; --help for more
  engines  a rendering in parts by Slurm, GNU parallel and Open Job Description, those
           that are installed; the bytes of one run must come of it
  package  packs the libraries, builds the packages, and tries to publish them
           in their order, all but the upload
  release [--target TARGET]
           all programs with manual pages and licences in target/release-archives,
           as an archive with the same bytes each time
  book     the pages of docs/ as a book with a search, target/book, by mdBook
  ci       format, clippy, layers, licences, other features and systems, tests,
           docs, book, packages, a first picture, a comparison, engines; stops at the
           first step that fails

Exit status: 0 done, 1 a task failed, 2 the command line was not understood;
of compare-integrators, needs, costs and scaling also 3 a scene or picture makes no sense, 4 nothing can
be written, 130 interrupted, 143 told to terminate.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let Some(task) = Task::of(&words) else {
        eprintln!("error: expected one task, found `{}`\n\n{HELP}", words.join(" "));
        return ExitCode::from(2);
    };
    let outcome = match task {
        Task::Layers => layers::run(),
        Task::CheckData { folder } => check_data::run(folder),
        Task::Ci => ci::run(),
        #[cfg(unix)]
        Task::Engines => engines::run(),
        Task::Package => package::publish_dry(),
        Task::Book => book::run(),
        Task::Release { target } => release::run(target),
        Task::Prove => prove::run(),
        Task::Faults { names, until } => faults::run(&names, until),
        Task::EditFault { name } => faults::edit(name),
        Task::SaveFault { name, wrong } => faults::save(name, wrong),
        Task::Relations(arguments) => relations::run(&arguments),
        Task::Stability(arguments) => stability::run(&arguments),
        Task::CountInstructions(arguments) => count_instructions::run(&arguments),
        Task::Chart { program, arguments } => {
            return charts::run(program, &arguments).unwrap_or_else(|error| failed(&error));
        }
        Task::Help => {
            println!("{HELP}");
            Ok(())
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failed(&error),
    }
}

fn failed(error: &anyhow::Error) -> ExitCode {
    eprintln!("error: {}", traylib_io::printable(&format!("{error:#}")));
    ExitCode::FAILURE
}
