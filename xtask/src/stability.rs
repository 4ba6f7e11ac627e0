//! `cargo xtask stability`: the failure scenes, by the program of the tests.

use crate::workspace;
use anyhow::{Context, Result, ensure};

/// Runs it with these arguments; an error unless all verdicts are as expected.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    let start = ["run", "--release", "--package", "traylib-tests", "--bin", "stability", "--"];
    let mut command = workspace::cargo(&[&start, arguments].concat());
    let status = command.status().with_context(|| format!("{command:?} does not start"))?;
    ensure!(status.success(), "stability ended with {status}");
    Ok(())
}
