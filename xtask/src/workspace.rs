//! The place of the workspace, and the calls of its cargo.

use anyhow::{Context, Result, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the workspace's `Cargo.toml`.
pub(crate) fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The cargo that runs this program, in the workspace's root.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root());
    command
}

/// Runs a command to its end.
///
/// # Errors
/// It does not start, or says that it failed.
pub(crate) fn finish(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?} does not start"))?;
    ensure!(status.success(), "{command:?} ended with {status}");
    Ok(())
}

/// Builds the programs with all that the tests of the workspace have built, and returns the folder
/// that they are in.
///
/// One package by itself would be built once more: what its dependencies can do is then for it
/// alone to say.
///
/// # Errors
/// Something does not build.
pub(crate) fn programs() -> Result<PathBuf> {
    finish(&mut cargo(&["test", "--workspace", "--no-run", "--quiet"]))?;
    let own = std::env::current_exe()?;
    let target = own.ancestors().nth(2).context("this program is in no folder of cargo's")?;
    Ok(target.join("debug"))
}
