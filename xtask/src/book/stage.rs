//! Lays out the pages and all that they link to.

use super::links::{is_outside, join, links};
use super::summary::SUMMARY;
use crate::workspace::root;
use anyhow::{Context, Result};
use std::fs;
use std::path::Path;

/// What mdBook is told.
const SETTINGS: &str = "docs/book.toml";

/// Writes the pages into a folder, which is emptied first, at their places in the project, and
/// beside them the pictures, scenes and other files that they link to.
///
/// # Errors
/// A page or a file cannot be read, or the copy not be written.
pub(super) fn lay_out(pages: &[String], folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    copy(SETTINGS, &folder.join("book.toml"))?;
    write(&folder.join("SUMMARY.md"), &summary(&read(SUMMARY)?))?;
    for page in pages {
        let text = read(page)?;
        write(&folder.join(page), &within_book(page, &text))?;
        for link in links(&text).iter().filter(|link| !is_outside(&link.target)) {
            let path = join(page, &link.target);
            if root().join(&path).is_file() && !pages.contains(&path) {
                copy(&path, &folder.join(&path))?;
            }
        }
    }
    Ok(())
}

/// The table of contents, which lies above its pages here.
fn summary(text: &str) -> String {
    replaced(text, |link| Some(join(SUMMARY, link)))
}

/// A page whose links to folders and to the table of contents are words alone: a book shows no
/// folders, and its contents beside every page.
fn within_book(page: &str, text: &str) -> String {
    replaced(text, |link| {
        let path = join(page, link);
        let leads = is_outside(link) || (path != SUMMARY && !root().join(path).is_dir());
        leads.then(|| link.to_string())
    })
}

/// Puts other targets into the links of a text; a link without one becomes its words.
fn replaced(text: &str, target: impl Fn(&str) -> Option<String>) -> String {
    let mut whole = text.to_string();
    // From the end, so that places before stay where they are. What holds a picture, or is given
    // further down the page, stays as it is.
    for link in links(text).iter().rev() {
        let written = &text[link.range.clone()];
        let end = format!("]({})", link.target);
        let Some(words) = written.strip_prefix('[').and_then(|rest| rest.strip_suffix(&end)) else {
            continue;
        };
        let link_now = match target(&link.target) {
            Some(target) => format!("[{words}]({target})"),
            None => words.to_string(),
        };
        whole.replace_range(link.range.clone(), &link_now);
    }
    whole
}

fn read(path: &str) -> Result<String> {
    fs::read_to_string(root().join(path)).with_context(|| format!("{path} cannot be read"))
}

fn write(path: &Path, text: &str) -> Result<()> {
    fs::create_dir_all(path.parent().context("no folder")?)?;
    fs::write(path, text).with_context(|| format!("{} cannot be written", path.display()))
}

fn copy(path: &str, to: &Path) -> Result<()> {
    fs::create_dir_all(to.parent().context("no folder")?)?;
    fs::copy(root().join(path), to).with_context(|| format!("{path} cannot be copied"))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_to_what_no_book_has_become_words() {
        let text = "see [`io`](crates/io), [docs](docs/growth.md) and [all](https://a.b/c)\
                    [.](docs/SUMMARY.md)";
        let found = within_book("README.md", text);
        assert_eq!(found, "see `io`, [docs](docs/growth.md) and [all](https://a.b/c).");
    }

    #[test]
    fn the_summary_moves_up() {
        let text = "- [A](growth.md)\n  - [B](../README.md)\n";
        assert_eq!(summary(text), "- [A](docs/growth.md)\n  - [B](README.md)\n");
    }

    #[test]
    fn pages_come_with_their_pictures() {
        let folder = tempfile::tempdir().unwrap();
        let pages = ["README.md", "docs/howto/shape.md"].map(String::from);
        lay_out(&pages, folder.path()).unwrap();
        for file in ["README.md", "scenes/pictures/cornell.png", "docs/howto/shape.md"] {
            assert!(folder.path().join(file).is_file(), "{file}");
        }
        assert!(!folder.path().join("crates/io").exists());
    }
}
