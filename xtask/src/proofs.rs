//! The proofs as programs: built once, run with what they found written down.

mod finding;
mod outcome;

pub(crate) use finding::Finding;
pub(crate) use outcome::Outcome;

use crate::workspace::cargo;
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The packages whose tests are about light and rays.
const PACKAGES: [&str; 8] = [
    "traylib-math",
    "traylib-statistics",
    "traylib-geometry",
    "traylib-materials",
    "traylib-scene",
    "traylib-integrators",
    "traylib-known",
    "traylib-tests",
];

/// The tests to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// The tests that `cargo test` runs.
    Fast,
    /// All tests, those at length too.
    Whole,
}

/// The point up to which test programs are run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Until {
    /// All of them.
    TheEnd,
    /// Those up to the first in which a test fails.
    OneFails,
}

/// Test programs, ready to run.
pub(crate) struct Proofs {
    programs: Vec<PathBuf>,
    /// The folder in which they are run.
    folder: PathBuf,
}

impl Proofs {
    /// Builds the test programs of the workspace at `root` with the profile for proofs.
    pub(crate) fn build(root: &Path, settings: impl FnOnce(&mut Command)) -> Result<Self> {
        let mut command = cargo(&["test", "--no-run", "--profile", "proof"]);
        command.args(["--lib", "--tests", "--message-format", "json-render-diagnostics"]);
        command.args(PACKAGES.iter().flat_map(|package| ["--package", package]));
        settings(command.current_dir(root));
        let output = command.stderr(Stdio::inherit()).output().context("cargo does not start")?;
        ensure!(output.status.success(), "the tests do not build");
        let programs: Vec<PathBuf> =
            String::from_utf8_lossy(&output.stdout).lines().filter_map(executable).collect();
        ensure!(!programs.is_empty(), "cargo built no tests");
        Ok(Self { programs, folder: root.join("tests") })
    }

    /// Runs them one after the other; what they find is written to `findings`.
    pub(crate) fn run(
        &self,
        extent: Extent,
        until: Until,
        findings: &Path,
        settings: impl Fn(&mut Command),
    ) -> Result<Outcome> {
        // Left from an earlier run, or not there at all.
        let _ = std::fs::remove_file(findings);
        let mut outcome = Outcome::default();
        for program in &self.programs {
            let mut command = Command::new(program);
            command.env("TRAYLIB_FINDINGS", findings).env("RUST_BACKTRACE", "0");
            command.current_dir(&self.folder);
            if extent == Extent::Whole {
                command.arg("--include-ignored");
            }
            settings(&mut command);
            let output = command.stderr(Stdio::piped()).output();
            let output = output.with_context(|| format!("{} does not start", program.display()))?;
            outcome.add(program, &output);
            if until == Until::OneFails && !outcome.failed.is_empty() {
                break;
            }
        }
        outcome.findings = Finding::read(findings)?;
        Ok(outcome)
    }
}

/// The test program that a line of cargo's messages tells of.
fn executable(line: &str) -> Option<PathBuf> {
    let message: Value = serde_json::from_str(line).ok()?;
    let is_test = message["profile"]["test"] == true;
    is_test.then(|| message["executable"].as_str().map(PathBuf::from))?
}
