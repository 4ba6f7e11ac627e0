//! Open Job Description, by its own command line.

use super::{OPTIONS, PARTS, Place};
use crate::workspace;
use anyhow::{Result, ensure};
use std::fs;

/// A step of seven tasks and one that merges.
pub(super) fn run(place: &Place) -> Result<String> {
    let template = workspace::root().join("docs/howto/cluster/render.openjd.yaml");
    let template = fs::canonicalize(template)?.display().to_string();
    let values = [
        format!("Folder={}", place.folder.display()),
        format!("Options={OPTIONS}"),
        format!("Parts={PARTS}"),
        format!("LastPart={}", PARTS - 1),
    ];
    let mut words = vec!["run", &template, "--step", "Merge", "--run-dependencies"];
    for value in &values {
        words.extend(["-p", value]);
    }
    let said = place.output("openjd", &words)?;
    let lines = |word: &str| said.lines().filter(|line| line.contains(word)).count();
    let (progress, status) = (lines("openjd_progress: "), lines("openjd_status: "));
    ensure!(
        progress >= PARTS as usize && status >= PARTS as usize,
        "it was told too little: {said}"
    );
    Ok(format!("{PARTS} tasks, a merge, {progress} lines of progress"))
}
