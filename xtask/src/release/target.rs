//! The system that programs are built for.

use anyhow::{Context, Result, ensure};
use std::process::Command;

/// A system as Rust names it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Target {
    pub(super) name: String,
}

impl Target {
    /// The system that the compiler runs on.
    pub(super) fn host() -> Result<Self> {
        let output = Command::new("rustc").arg("-vV").output().context("rustc does not start")?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let name = text.lines().find_map(|line| line.strip_prefix("host: "));
        Ok(Self { name: name.context("rustc does not name its host")?.into() })
    }

    /// A system that is named.
    ///
    /// # Errors
    /// Its target is not installed, or no linker for it is.
    pub(super) fn installed(name: &str) -> Result<Self> {
        let target = Self { name: name.into() };
        if target == Self::host()? {
            return Ok(target);
        }
        let output = Command::new("rustup").args(["target", "list", "--installed"]).output();
        let installed = output.map(|output| output.stdout).unwrap_or_default();
        ensure!(
            String::from_utf8_lossy(&installed).lines().any(|line| line == name),
            "{name} is left out: its target is not installed (rustup target add {name})"
        );
        let linker = target.linker();
        let answer = linker.as_ref().map(|linker| Command::new(linker).arg("--version").output());
        ensure!(
            answer.is_none_or(|answer| answer.is_ok_and(|output| output.status.success())),
            "{name} is left out: its linker {} is not installed",
            linker.unwrap_or_default()
        );
        Ok(target)
    }

    pub(super) fn is_windows(&self) -> bool {
        self.name.contains("windows")
    }

    /// The end of a program's name.
    pub(super) fn program_ending(&self) -> &'static str {
        if self.is_windows() { ".exe" } else { "" }
    }

    /// The linker that cargo calls, where it is one of a known name: that of its settings, or
    /// that by which rustc goes for Windows.
    fn linker(&self) -> Option<String> {
        let variable = self.name.to_uppercase().replace('-', "_");
        let set = std::env::var(format!("CARGO_TARGET_{variable}_LINKER")).ok();
        set.or_else(|| {
            (self.name == "x86_64-pc-windows-gnu").then(|| String::from("x86_64-w64-mingw32-gcc"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_target_that_is_not_there_is_told_in_a_line() {
        let error = Target::installed("pdp11-dec-unix").unwrap_err().to_string();
        assert!(error.starts_with("pdp11-dec-unix is left out: its target is not"), "{error}");
        assert_eq!(error.lines().count(), 1);
    }

    #[test]
    fn the_host_is_installed() {
        let host = Target::host().unwrap();
        assert_eq!(Target::installed(&host.name).unwrap(), host);
        assert_eq!(host.program_ending(), std::env::consts::EXE_SUFFIX);
    }
}
