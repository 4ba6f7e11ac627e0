//! A fault: a mistake that a renderer may well have, as a patch.

use crate::workspace::root;
use anyhow::{Context, Result, bail, ensure};
use diffy::Patch;
use diffy::patch_set::{FileOperation, ParseOptions, PatchSet};
use std::fs;
use std::path::Path;

/// A mistake, and the patch that puts it into the clean sources, asleep.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    /// The name, by which the environment and its file call it.
    pub(super) name: String,
    /// The mistake in words: the text before the patch.
    pub(super) wrong: String,
    /// A unified diff.
    patch: String,
}

/// The change that a fault makes to one file of the workspace.
pub(super) struct Change<'a> {
    /// From the workspace's root.
    pub(super) file: String,
    pub(super) patch: Patch<'a, str>,
}

impl Fault {
    /// All faults, by name: the files of `xtask/faults`.
    pub(super) fn all() -> Result<Vec<Self>> {
        let folder = root().join("xtask/faults");
        let entries = fs::read_dir(&folder)
            .with_context(|| format!("cannot read {}", folder.display()))?
            .map(|entry| Ok(entry?.path()))
            .collect::<Result<Vec<_>>>()?;
        let patches = entries.into_iter().filter(|path| path.extension().is_some_and(is_patch));
        let mut faults = patches.map(|path| Self::read(&path)).collect::<Result<Vec<_>>>()?;
        faults.sort_by(|a, b| a.name.cmp(&b.name));
        Ok(faults)
    }

    fn read(file: &Path) -> Result<Self> {
        let text =
            fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
        let name = file.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into());
        Self::parse(&name, &text).with_context(|| format!("{}", file.display()))
    }

    /// A fault from the text of its file.
    pub(super) fn parse(name: &str, text: &str) -> Result<Self> {
        check_name(name)?;
        let start = text.find("--- a/").context("no patch")?;
        let (wrong, patch) = text.split_at(start);
        let fault = Self { name: name.into(), wrong: wrong.trim().into(), patch: patch.into() };
        ensure!(!fault.wrong.is_empty(), "does not say what is wrong before its patch");
        for change in fault.changes()? {
            fault.check(&change)?;
        }
        Ok(fault)
    }

    /// Every change asks whether this fault is awake, and for no other.
    fn check(&self, change: &Change<'_>) -> Result<()> {
        let Change { file, patch } = change;
        let text = patch.to_string();
        let asked = text.lines().filter(|line| line.starts_with('+')).flat_map(|line| {
            let questions = line.split("injected!(").skip(1);
            questions.map(|rest| rest.split(')').next().unwrap_or_default())
        });
        let asked: Vec<&str> = asked.collect();
        let name = &self.name;
        ensure!(!asked.is_empty(), "changes {file} without asking for `injected!({name})`");
        let other = asked.iter().find(|other| *other != name);
        ensure!(other.is_none(), "asks for another fault, {}", other.unwrap_or(&""));
        Ok(())
    }

    /// Returns its changes, one file each.
    pub(super) fn changes(&self) -> Result<Vec<Change<'_>>> {
        PatchSet::parse(&self.patch, ParseOptions::unidiff())
            .map(|patch| {
                let patch = patch.context("the patch cannot be read")?;
                let FileOperation::Modify { modified, .. } = patch.operation().strip_prefix(1)
                else {
                    bail!("a fault changes files that are there");
                };
                let file = modified.into_owned();
                let patch = patch.into_patch();
                let patch = patch.as_text().context("a fault changes text")?.clone();
                Ok(Change { file, patch })
            })
            .collect()
    }

    /// Its file's text.
    pub(super) fn text(&self) -> String {
        format!("{}\n\n{}", self.wrong, self.patch)
    }
}

/// Returns the file of a fault, from the workspace's root.
pub(super) fn file_of(name: &str) -> String {
    format!("xtask/faults/{name}.patch")
}

/// Names are those of an enum's variants.
pub(super) fn check_name(name: &str) -> Result<()> {
    let is_name = name.starts_with(|c: char| c.is_ascii_uppercase())
        && name.chars().all(|c| c.is_ascii_alphanumeric());
    ensure!(is_name, "`{name}` is not a name for a fault: one is spelled as RasterShifted");
    Ok(())
}

fn is_patch(extension: &std::ffi::OsStr) -> bool {
    extension == "patch"
}
