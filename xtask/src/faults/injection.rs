//! Faults put into texts.

use super::fault::{Change, Fault};
use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Files of the workspace that differ from what is there, by their paths from its root.
pub(super) type Texts = BTreeMap<String, String>;

/// All faults together, each a patch of the clean sources under `root`; an error with a
/// line for each that does not apply.
pub(super) fn inject_all(root: &Path, faults: &[Fault]) -> Result<Texts> {
    let mut clean = Texts::new();
    let mut injected = Texts::new();
    let mut refusals = Vec::new();
    for fault in faults {
        for change in fault.changes()? {
            let file = &change.file;
            if !clean.contains_key(file) {
                clean.insert(file.clone(), read(root, file)?);
            }
            let before = &clean[file];
            let sum = injected.entry(file.clone()).or_insert_with(|| before.clone());
            match inject(before, sum, &fault.name, &change) {
                Ok(more) => *sum = more,
                Err(refusal) => refusals.push(refusal),
            }
        }
    }
    if refusals.is_empty() { Ok(injected) } else { bail!("{}", refusals.join("\n")) }
}

/// One change of the `clean` text added to those `others` that are made already.
pub(super) fn inject(
    clean: &str,
    others: &str,
    fault: &str,
    change: &Change<'_>,
) -> Result<String, String> {
    let file = &change.file;
    let mend = format!(
        "`cargo xtask faults --edit {fault}`, make the change there, then \
         `cargo xtask faults --save {fault}`"
    );
    let alone = diffy::apply(clean, &change.patch)
        .map_err(|_| format!("{fault}.patch no longer applies to {file}: {mend}"))?;
    // Not one after the other: lines around one may be those of another.
    diffy::merge(clean, others, &alone)
        .map_err(|_| format!("{fault}.patch changes lines of {file} that another does: {mend}"))
}

/// A file of the workspace.
pub(super) fn read(root: &Path, file: &str) -> Result<String> {
    fs::read_to_string(root.join(file)).with_context(|| format!("cannot read {file}"))
}
