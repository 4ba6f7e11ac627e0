//! `cargo xtask relations`: drawn scenes, by the program of the tests.

use crate::workspace;
use anyhow::{Context, Result, ensure};

/// Runs it with these arguments; an error unless all relations hold.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    let start = ["run", "--release", "--package", "traylib-tests", "--bin", "relations", "--"];
    let mut command = workspace::cargo(&[&start, arguments].concat());
    let status = command.status().with_context(|| format!("{command:?} does not start"))?;
    ensure!(status.success(), "relations ended with {status}");
    Ok(())
}
