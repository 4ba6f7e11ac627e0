//! `cargo xtask book`: the pages of the project as a book.
//!
//! `docs/SUMMARY.md` is its table of contents. It names pages outside of `docs/`, and pages show
//! pictures from elsewhere, which mdBook takes no further than its own folder: so all of it is
//! first laid out below `target/book-pages` as it is in the project.

#[cfg(all(test, unix))]
mod commands;
mod links;
#[cfg(test)]
mod page;
mod result;
mod stage;
mod summary;
#[cfg(test)]
mod tests;

use crate::workspace::{finish, root};
use anyhow::Result;
use std::process::Command;

/// Where the pages are laid out, and where the book is written, in the workspace.
const PAGES: &str = "target/book-pages";
const BOOK: &str = "target/book";

/// Builds the book; an error if a link of it leads nowhere.
pub(crate) fn run() -> Result<()> {
    let (pages, book) = (root().join(PAGES), root().join(BOOK));
    stage::lay_out(&summary::pages()?, &pages)?;
    // The folder is read from the one of the pages, unless it is absolute.
    let book = std::path::absolute(book)?;
    finish(Command::new("mdbook").arg("build").arg(&pages).arg("--dest-dir").arg(&book))?;
    let links = result::check(&book)?;
    println!("{BOOK}/index.html: {links} links lead to files of the book");
    Ok(())
}
