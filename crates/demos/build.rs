//! Finds out which revision is built.
#![allow(clippy::print_stdout, reason = "so Cargo is told")]

use std::path::Path;
use std::process::Command;

/// Sets `TRAYLIB_VERSION` to the package's version, and the commit where the sources are
/// files of a Git repository.
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let version = std::env::var("CARGO_PKG_VERSION").unwrap_or_default();
    let version = match revision() {
        Some(revision) => format!("{version} ({revision})"),
        None => version,
    };
    println!("cargo::rustc-env=TRAYLIB_VERSION={version}");
}

fn revision() -> Option<String> {
    // A package that was unpacked inside of somebody's repository is no part of it.
    git(&["ls-files", "--error-unmatch", "Cargo.toml"])?;
    // It gets a line with each commit and checkout.
    let log = git(&["rev-parse", "--git-path", "logs/HEAD"])?;
    if Path::new(&log).exists() {
        println!("cargo::rerun-if-changed={log}");
    }
    git(&["rev-parse", "--short=12", "HEAD"])
}

/// Returns the output of Git; `None` without Git or if it refuses.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
