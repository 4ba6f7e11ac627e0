//! The table of contents.

use super::links::{join, links};
use crate::workspace::root;
use anyhow::{Context, Result};

/// The page that names all others, in the order in which they are read.
pub(super) const SUMMARY: &str = "docs/SUMMARY.md";

/// Returns the pages of the book by their paths in the project.
///
/// # Errors
/// The table of contents cannot be read.
pub(super) fn pages() -> Result<Vec<String>> {
    let text = std::fs::read_to_string(root().join(SUMMARY)).context(SUMMARY)?;
    Ok(links(&text).iter().map(|link| join(SUMMARY, &link.target)).collect())
}
