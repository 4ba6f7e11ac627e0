//! A copy of the workspace with some files changed.

use super::injection::Texts;
use anyhow::{Context, Result};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The folder of all that is made of faults, from the workspace's root.
pub(super) const FOLDER: &str = "target/faults";

/// Makes `copy` the workspace under `root` with `changed` texts. What is right already
/// is left alone, so that cargo builds again only what has changed.
pub(super) fn write(root: &Path, copy: &Path, changed: &Texts) -> Result<()> {
    let mut wanted = files(root)?;
    for file in &wanted {
        if !changed.contains_key(file) {
            let bytes = fs::read(root.join(file)).with_context(|| format!("cannot read {file}"))?;
            write_file(&copy.join(file), &bytes)?;
        }
    }
    for (file, text) in changed {
        write_file(&copy.join(file), text.as_bytes())?;
    }
    wanted.extend(changed.keys().cloned());
    for left_over in files(copy)?.difference(&wanted) {
        let file = copy.join(left_over);
        fs::remove_file(&file).with_context(|| format!("cannot remove {}", file.display()))?;
    }
    Ok(())
}

fn write_file(file: &Path, bytes: &[u8]) -> Result<()> {
    if fs::read(file).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    let folder = file.parent().context("a file is in a folder")?;
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    fs::write(file, bytes).with_context(|| format!("cannot write {}", file.display()))
}

/// The files of a workspace, by their paths from its root, without what cargo and git keep
/// there.
pub(super) fn files(root: &Path) -> Result<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        let path = root.join(&folder);
        let entries =
            fs::read_dir(&path).with_context(|| format!("cannot read {}", path.display()))?;
        for entry in entries {
            let entry = entry?;
            let name = entry.file_name();
            let name = name.to_str().with_context(|| format!("{} is no text", name.display()))?;
            // What a link to a folder leads to is copied like any folder.
            let is_folder = fs::metadata(entry.path())?.is_dir();
            if name == ".git" || (is_folder && name == "target") {
                continue;
            }
            if is_folder {
                folders.push(format!("{folder}{name}/"));
            } else {
                found.insert(format!("{folder}{name}"));
            }
        }
    }
    Ok(found)
}
