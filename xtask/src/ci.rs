//! `cargo xtask ci`: everything a change must pass, in the order that finds a
//! fault soonest.

mod apart;

#[cfg(unix)]
use crate::engines;
use crate::{layers, package, workspace};
use anyhow::{Context, Result, ensure};
use std::process::Command;
use std::time::Instant;

/// Runs every step; an error at the first that fails, with its name.
pub(crate) fn run() -> Result<()> {
    let start = Instant::now();
    step("fmt", || cargo(&["fmt", "--all", "--check"]))?;
    step("clippy", || {
        cargo(&["clippy", "--workspace", "--all-targets", "--", "--deny", "warnings"])
    })?;
    step("layers", layers::run)?;
    step("deny", apart::deny)?;
    step("features", apart::features)?;
    step("targets", apart::targets)?;
    step("test", || cargo(&["test", "--workspace"]))?;
    step("doc", document)?;
    step("book", apart::book)?;
    step("package", package::pack)?;
    step("apart", apart::packages)?;
    step("check", || program("bdpt", &["--check"]))?;
    step("picture", picture)?;
    step("compare", compare)?;
    #[cfg(unix)]
    step("engines", engines::run)?;
    println!("ci: all steps passed, {:.1} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn step(name: &str, task: impl FnOnce() -> Result<()>) -> Result<()> {
    println!("== {name}");
    let start = Instant::now();
    let outcome = task();
    let end = if outcome.is_ok() { "passed" } else { "FAILED" };
    println!("== {name}: {end}, {:.1} s", start.elapsed().as_secs_f64());
    outcome.with_context(|| format!("step `{name}` failed"))
}

fn document() -> Result<()> {
    let mut command = workspace::cargo(&["doc", "--workspace", "--no-deps"]);
    workspace::finish(command.env("RUSTDOCFLAGS", "--deny warnings"))
}

/// The README's first command, made small: a picture must lie there afterwards.
fn picture() -> Result<()> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("bdpt.png");
    let path = file.to_str().context("the folder for temporary files has no UTF-8 name")?;
    program("bdpt", &["--spp", "1", "--resolution", "64x48", "--outfile", path])?;
    let size = std::fs::metadata(&file).context("bdpt left no picture")?.len();
    ensure!(size > 0, "bdpt left an empty picture");
    Ok(())
}

/// The README's third command, and what it made, in a browser where there is one.
fn compare() -> Result<()> {
    let folder = tempfile::tempdir()?;
    let path =
        folder.path().to_str().context("the folder for temporary files has no UTF-8 name")?;
    program("compare-integrators", &["--quick", "--out", path])?;
    let page = ["test", "--workspace", "--test", "browser", "the_page"];
    workspace::finish(workspace::cargo(&page).env("TRAYLIB_COMPARISON", path))
}

/// Runs a program as the tests have built it: a release would take longer to build than all that is
/// rendered here saves.
fn program(name: &str, arguments: &[&str]) -> Result<()> {
    let file = workspace::programs()?.join(name);
    workspace::finish(Command::new(file).args(arguments).current_dir(workspace::root()))
}

fn cargo(arguments: &[&str]) -> Result<()> {
    workspace::finish(&mut workspace::cargo(arguments))
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;

    #[test]
    fn a_failing_step_is_named_and_keeps_its_cause() {
        let error = step("sieve", || bail!("too coarse")).unwrap_err();
        assert_eq!(format!("{error:#}"), "step `sieve` failed: too coarse");
    }

    #[test]
    fn a_program_that_fails_is_an_error() {
        assert!(cargo(&["--version"]).is_ok());
        assert!(cargo(&["no-such-command-of-cargo"]).is_err());
    }
}
