//! `cargo xtask compare-integrators`: the chart of speed against accuracy, by the
//! program of that name.

use crate::workspace;
use anyhow::{Context, Result};
use std::process::ExitCode;

/// Runs it with these arguments; its exit status is the task's.
pub(crate) fn run(arguments: &[&str]) -> Result<ExitCode> {
    let package = ["--package", "traylib-compare", "--bin", "compare-integrators", "--"];
    let start = ["run", "--release"];
    let mut command = workspace::cargo(&[&start[..], &package, arguments].concat());
    // File names are meant from where the user stands.
    command.current_dir(std::env::current_dir()?);
    let status = command.status().with_context(|| format!("{command:?} does not start"))?;
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}
