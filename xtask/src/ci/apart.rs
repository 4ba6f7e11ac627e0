//! Checks what the workspace's own build does not reach: other features, other systems, and the
//! packages that stand apart. What a machine lacks for it is said in a line and left out.

use super::cargo;
use crate::{book, workspace};
use anyhow::{Result, ensure};
use std::process::{Command, Stdio};

/// Systems that nobody may run this on, but that must compile.
const TARGETS: [&str; 3] =
    ["x86_64-pc-windows-gnu", "aarch64-apple-darwin", "aarch64-unknown-linux-gnu"];

/// Packages with workspaces of their own.
const APART: [&str; 2] = ["fuzz", "crates/geometry/peers"];

/// Licences, sources and versions of all dependencies, by `deny.toml`, also of the packages
/// that stand apart. Advisories are not asked for: they come from elsewhere, and change while
/// nothing here does.
pub(super) fn deny() -> Result<()> {
    if !answers(&mut workspace::cargo(&["deny", "--version"])) {
        left_out("cargo-deny", "it is not installed");
        return Ok(());
    }
    for folder in [&["."][..], &APART].concat() {
        let manifest = format!("{folder}/Cargo.toml");
        // Unlocked, it would write lock files anew, and no step would see that one is stale.
        let of = ["deny", "--locked", "--manifest-path", &manifest, "--log-level", "error"];
        cargo(&[&of[..], &["check", "bans", "licenses", "sources"]].concat())?;
    }
    Ok(())
}

/// The crates that others take alone, with no feature and with each.
pub(super) fn features() -> Result<()> {
    for features in ["", "rayon", "serde"] {
        let package = ["check", "--package", "traylib-geometry", "--no-default-features"];
        cargo(&[&package[..], &["--features", features]].concat())?;
    }
    for features in ["", "serde"] {
        for package in ["traylib-math", "traylib-statistics"] {
            cargo(&["check", "--package", package, "--features", features])?;
        }
    }
    Ok(())
}

/// The programs and all that they use, for other systems.
pub(super) fn targets() -> Result<()> {
    let installed = Command::new("rustup").args(["target", "list", "--installed"]).output();
    let installed = installed.map(|output| output.stdout).unwrap_or_default();
    let installed = String::from_utf8_lossy(&installed);
    for target in TARGETS {
        if installed.lines().any(|line| line == target) {
            cargo(&["check", "--package", "traylib-demos", "--target", target])?;
        } else {
            left_out(target, "the target is not installed");
        }
    }
    Ok(())
}

/// The book, whose links are followed.
pub(super) fn book() -> Result<()> {
    if answers(Command::new("mdbook").arg("--version")) {
        return book::run();
    }
    left_out("the book", "mdbook is not installed");
    Ok(())
}

/// Compiles the packages that stand apart, as their lock files have it.
pub(super) fn packages() -> Result<()> {
    for folder in APART {
        let manifest = format!("{folder}/Cargo.toml");
        let of = ["--locked", "--manifest-path", &manifest];
        let fetch = workspace::cargo(&[&["fetch"][..], &of].concat()).output()?;
        let complaint = String::from_utf8_lossy(&fetch.stderr);
        // A lock file that no longer fits is a fault, a registry out of reach is none.
        ensure!(!complaint.contains("--locked"), "{manifest}: {complaint}");
        if fetch.status.success() {
            let check = [&["check"][..], &of, &["--target-dir", "target/apart"]].concat();
            workspace::finish(&mut workspace::cargo(&check))?;
        } else {
            left_out(folder, "what it depends on cannot be had");
        }
    }
    Ok(())
}

fn left_out(what: &str, why: &str) {
    println!("{what}: left out, {why}");
}

/// Tells whether a command starts and succeeds; it may say what it likes.
fn answers(command: &mut Command) -> bool {
    let silent = command.stdout(Stdio::null()).stderr(Stdio::null());
    silent.status().is_ok_and(|status| status.success())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workspace::root;

    #[test]
    fn a_command_that_is_not_there_does_not_answer() {
        assert!(answers(&mut workspace::cargo(&["--version"])));
        assert!(!answers(&mut workspace::cargo(&["no-such-command-of-cargo"])));
        assert!(!answers(&mut Command::new("no-such-program")));
    }

    #[test]
    fn what_stands_apart_has_a_lock_file() {
        for folder in APART {
            assert!(root().join(folder).join("Cargo.lock").is_file(), "{folder}");
        }
    }
}
