//! `cargo xtask faults --edit` and `--save`: a patch mended, or made.

use super::copy::{self, FOLDER};
use super::fault::{Fault, check_name, file_of};
use super::injection::{Texts, inject, inject_all, read};
use super::support;
use crate::workspace::root;
use anyhow::{Context, Result, bail};
use diffy::DiffOptions;
use std::fs;
use std::path::Path;

/// Makes `target/faults/edit` the clean sources with this fault alone, as far as its patch
/// applies; with none if it is a new one.
pub(crate) fn edit(name: &str) -> Result<()> {
    check_name(name)?;
    let faults = Fault::all()?;
    let mut changed = Texts::new();
    for change in faults.iter().filter(|fault| fault.name == name).map(Fault::changes) {
        for change in change? {
            let clean = read(root(), &change.file)?;
            if let Ok(text) = inject(&clean, &clean, name, &change) {
                changed.insert(change.file, text);
            } else {
                println!("to be made by hand:\n{}", change.patch);
            }
        }
    }
    let others = faults.iter().map(|fault| fault.name.as_str()).filter(|&other| other != name);
    support::add(root(), &mut changed, others.chain([name]))?;
    let tree = format!("{FOLDER}/edit");
    copy::write(root(), &root().join(&tree), &changed)?;
    println!("change {tree}, asking for `traylib_math::injected!({name})`;");
    println!("then `cargo xtask faults --save {name}`, for a new fault followed by what is wrong");
    Ok(())
}

/// Writes the patch of a fault: how `target/faults/edit` differs from the sources. What is
/// wrong need only be said of a new one.
pub(crate) fn save(name: &str, wrong: Option<&str>) -> Result<()> {
    let faults = Fault::all()?;
    let known = faults.iter().find(|fault| fault.name == name).map(|fault| &*fault.wrong);
    let wrong = wrong.or(known).with_context(|| {
        format!("{name} is new: `cargo xtask faults --save {name} \"what is wrong\"`")
    })?;
    let patch = difference(root(), &root().join(FOLDER).join("edit"))?;
    let fault = Fault::parse(name, &format!("{wrong}\n\n{patch}"))?;
    let file = file_of(name);
    fs::write(root().join(&file), fault.text()).with_context(|| format!("cannot write {file}"))?;
    println!("{file}");
    inject_all(root(), &Fault::all()?).map(drop)
}

/// A patch that makes the workspace at `changed` of that at `clean`.
pub(super) fn difference(clean: &Path, changed: &Path) -> Result<String> {
    let (before, after) = (copy::files(clean)?, copy::files(changed)?);
    let mut patch = String::new();
    for file in before.union(&after).filter(|file| *file != support::MODULE) {
        let bytes = |root: &Path| fs::read(root.join(file)).ok();
        if bytes(clean) == bytes(changed) {
            continue;
        }
        if !before.contains(file) || !after.contains(file) {
            bail!("{file} is in one tree only: a fault changes files that are there");
        }
        patch += &difference_of(file, &read(clean, file)?, &read(changed, file)?);
    }
    Ok(patch)
}

/// A patch of one file; empty if only the support for faults was added.
fn difference_of(file: &str, clean: &str, changed: &str) -> String {
    let own = if file == support::CRATE { support::DECLARATION } else { "" };
    let changed = changed.strip_suffix(own).unwrap_or(changed);
    if clean == changed {
        return String::new();
    }
    let mut options = DiffOptions::new();
    options.set_original_filename(format!("a/{file}"));
    options.set_modified_filename(format!("b/{file}"));
    options.create_patch(clean, changed).to_string()
}
