//! `cargo xtask compare-integrators` and `scaling`, by the programs of those names.

use crate::workspace;
use anyhow::{Context, Result};
use std::process::ExitCode;

/// Runs the program with these arguments; its exit status is the task's.
pub(crate) fn run(program: &str, arguments: &[&str]) -> Result<ExitCode> {
    let start = ["run", "--release", "--package", "traylib-compare", "--bin", program, "--"];
    let mut command = workspace::cargo(&[&start, arguments].concat());
    // File names are meant from where the user stands.
    command.current_dir(std::env::current_dir()?);
    let status = command.status().with_context(|| format!("{command:?} does not start"))?;
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}
