//! `cargo xtask release`: the programs in an archive, for those who have no cargo.
//!
//! Of the same files the archive has the same bytes: see [`archive`].

mod archive;
mod content;
mod target;

use crate::sha256::sha256;
use crate::workspace::{cargo, finish, root};
use anyhow::{Context, Result};
use archive::Form;
use std::path::{Path, PathBuf};
use std::process::Command;
use target::Target;

/// Where archives are left, in the workspace.
const FOLDER: &str = "target/release-archives";

/// The profile that they are built by, and the folder that cargo puts them in.
const PROFILE: &str = "dist";

/// The packages of the programs, and what they are called.
const PACKAGES: [&str; 2] = ["traylib-demos", "traylib-realtime"];
const PROGRAMS: [&str; 8] =
    ["trace", "puremc", "directlight", "particle", "bdpt", "film", "scene", "realtime"];

/// Builds the programs for a system, that of the compiler if none is named, and packs them.
///
/// # Errors
/// The system's target or linker is not installed, or something cannot be built or written.
pub(crate) fn run(name: Option<&str>) -> Result<()> {
    let host = Target::host()?;
    let target = name.map_or_else(|| Ok(host.clone()), Target::installed)?;
    // Manual pages and completions are told by programs that run here.
    let own = build(&host, &host)?;
    let built = if target == host { own.clone() } else { build(&target, &host)? };
    let folder = format!("traylib-{}-{}", env!("CARGO_PKG_VERSION"), target.name);
    let files = content::files(&own, &built, target.program_ending())?;
    let form = if target.is_windows() { Form::Zip } else { Form::TarGz };
    let bytes = archive::pack(&folder, &files, time(), form)?;
    let file = format!("{folder}.{}", form.ending());
    write(&file, &bytes)?;
    write(&format!("{file}.sha256"), format!("{}  {file}\n", sha256(&bytes)).as_bytes())?;
    println!("{FOLDER}/{file}: {} files, {:.1} MB", files.len(), bytes.len() as f64 / 1e6);
    Ok(())
}

/// Builds all programs for a target; returns the folder that they are in.
fn build(target: &Target, host: &Target) -> Result<PathBuf> {
    let mut command = cargo(&["build", "--profile", PROFILE, "--locked", "--bins"]);
    for package in PACKAGES {
        command.args(["--package", package]);
    }
    let folder = match std::env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => std::env::current_dir()?.join(folder),
        None => root().join("target"),
    };
    if target == host {
        finish(&mut command)?;
        return Ok(folder.join(PROFILE));
    }
    finish(command.args(["--target", &target.name]))?;
    Ok(folder.join(&target.name).join(PROFILE))
}

/// The time that all files of an archive have: that of the commit, in seconds since 1970.
fn time() -> u64 {
    let log = Command::new("git").args(["log", "-1", "--format=%ct"]).current_dir(root()).output();
    let text = log.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    text.ok().and_then(|text| text.trim().parse().ok()).unwrap_or(0)
}

fn write(name: &str, bytes: &[u8]) -> Result<()> {
    let path = root().join(FOLDER).join(name);
    std::fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
    std::fs::write(&path, bytes).with_context(|| format!("{} cannot be written", path.display()))
}
