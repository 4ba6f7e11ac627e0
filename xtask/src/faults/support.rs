//! The support that a copy of the sources needs to awaken faults.

use super::injection::{Texts, read};
use anyhow::Result;
use std::path::Path;

/// The variable of the environment that names the fault to awaken.
pub(super) const VARIABLE: &str = "TRAYLIB_FAULT";

/// The module that faults ask; it is added to the crate on the lowest floor.
pub(super) const MODULE: &str = "crates/math/src/faults.rs";

/// The file that gets [`DECLARATION`] at its end.
pub(super) const CRATE: &str = "crates/math/src/lib.rs";

/// Makes the module known.
pub(super) const DECLARATION: &str = "\npub mod faults;\n";

/// Adds the module with all these faults.
pub(super) fn add<'a>(
    root: &Path,
    texts: &mut Texts,
    names: impl Iterator<Item = &'a str>,
) -> Result<()> {
    let names: Vec<&str> = names.collect();
    let module = include_str!("../../faults/injected.rs");
    texts.insert(MODULE.into(), format!("{module}faults! {{ {} }}\n", names.join(" ")));
    let text = texts.remove(CRATE).map_or_else(|| read(root, CRATE), Ok)?;
    texts.insert(CRATE.into(), text + DECLARATION);
    Ok(())
}
