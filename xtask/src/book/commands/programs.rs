//! The programs, built and run.

use crate::workspace::cargo;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// The folder of all programs of the project, as this test was built.
#[derive(Debug)]
pub(super) struct Programs {
    folder: PathBuf,
}

impl Programs {
    /// Builds all of them beside this test, once.
    pub(super) fn get() -> &'static Self {
        static PROGRAMS: OnceLock<Programs> = OnceLock::new();
        PROGRAMS.get_or_init(Self::build)
    }

    fn build() -> Self {
        let test = std::env::current_exe().unwrap();
        // The test lies in PROFILE/deps.
        let folder = test.ancestors().nth(2).unwrap().to_path_buf();
        let name = folder.file_name().unwrap().to_str().unwrap();
        let profile = if name == "debug" { "dev" } else { name };
        // With examples the features are those of `cargo test --workspace`, and nothing is built
        // twice.
        let what = ["--workspace", "--bins", "--examples", "--target-dir"];
        let start = ["build", "--quiet", "--locked", "--profile", profile];
        let status = cargo(&start).args(what).arg(folder.parent().unwrap()).status().unwrap();
        assert!(status.success(), "the programs cannot be built");
        Self { folder }
    }

    /// Runs a program in a folder; an error tells what it complained of.
    pub(super) fn run(
        &self,
        name: &str,
        arguments: &[String],
        folder: &Path,
    ) -> Result<(), String> {
        let places = [self.folder.join(name), self.folder.join("examples").join(name)];
        let program = places.iter().find(|path| path.is_file());
        let program = program.ok_or_else(|| format!("no program is named {name}"))?;
        let mut command = Command::new(program);
        command.args(arguments).current_dir(folder).stdin(Stdio::null());
        let output = command.output().map_err(|error| error.to_string())?;
        let has_noise = arguments.iter().any(|word| word == "--noise");
        match output.status.code() {
            Some(0) => Ok(()),
            // The error that was asked for is not reached with so few samples.
            Some(5) if has_noise => Ok(()),
            _ => Err(format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr))),
        }
    }
}
