//! `cargo xtask stability`: every method over every failure scene, judged.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

use std::path::PathBuf;
use std::process::ExitCode;
use traylib_integrators::Method;
use traylib_io::printable;
use traylib_io::write_file;
use traylib_tests::stability::expected::METHODS;
use traylib_tests::stability::page::{page, save_pictures};
use traylib_tests::stability::run::{Choice, run};
use traylib_tests::stability::table::{Agreement, Judged, markdown};

const HELP: &str = "\
Renders every failure scene by every method and judges what comes of it.

Usage: cargo xtask stability [OPTIONS]

  --scene F10      this scene alone
  --method bdpt    this method alone, as \"directlight --combine\"; it is then
                   compared with itself
  --quick          an eighth of the passes: for a look, not for a verdict
  --out FOLDER     where table.md, index.html and results.json go
                   [default: target/stability]

Exit status: 0 all as expected or corrected, 1 not so, 2 the command line was
not understood.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (help, words): (Vec<String>, Vec<String>) =
        arguments.into_iter().partition(|word| word == "--help" || word == "-h");
    // What is wrong beside a wish for help is told, as by the other programs.
    let Some((choice, folder)) = understand(&words) else {
        eprintln!("error: not understood: `{}`\n\n{HELP}", words.join(" "));
        return ExitCode::from(2);
    };
    if !help.is_empty() {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    match stability(&choice, &folder) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {}", printable(&error.to_string()));
            ExitCode::FAILURE
        }
    }
}

fn understand(arguments: &[String]) -> Option<(Choice, PathBuf)> {
    let mut choice = Choice::default();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let mut folder = PathBuf::from(root).join("target/stability");
    let mut words = arguments.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--scene" => choice.scene = Some(words.next()?.clone()),
            "--method" => choice.method = Some(method(words.next()?)?),
            "--quick" => choice.quick = true,
            "--out" => folder = PathBuf::from(words.next()?),
            _ => return None,
        }
    }
    Some((choice, folder))
}

/// A method of the table; `trace` stands there for many samples.
fn method(text: &str) -> Option<Method> {
    let method = text.parse::<Method>().ok()?.for_many_samples();
    METHODS.contains(&method).then_some(method)
}

/// Tells whether all verdicts are as they should be; at least one there must be.
fn stability(choice: &Choice, folder: &PathBuf) -> Result<bool, Box<dyn std::error::Error>> {
    let rows = run(choice, &|line| eprintln!("{line}"));
    std::fs::create_dir_all(folder)?;
    let cells: Vec<Judged> = rows.iter().flat_map(|row| row.cells.clone()).collect();
    let table = markdown(&cells);
    println!("{table}");
    write_file(&folder.join("table.md"), table.as_bytes())?;
    write_file(&folder.join("results.json"), &serde_json::to_vec_pretty(&cells)?)?;
    write_file(&folder.join("index.html"), page(&rows).as_bytes())?;
    for row in &rows {
        save_pictures(folder, row)?;
    }
    let disagree = cells.iter().filter(|cell| cell.agreement() == Agreement::Disagrees).count();
    eprintln!("{} cells, {disagree} neither expected nor corrected", cells.len());
    Ok(!cells.is_empty() && disagree == 0)
}
