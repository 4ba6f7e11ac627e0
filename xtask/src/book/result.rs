//! Whether the links of the book that was built lead to files of it.

use super::links::{is_outside, join};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};

/// Follows all links of all pages in a folder, and counts them.
///
/// # Errors
/// A page cannot be read, or links lead nowhere: they are named.
pub(super) fn check(book: &Path) -> Result<usize> {
    let (mut count, mut broken) = (0, Vec::new());
    for page in pages(book)? {
        let text = fs::read_to_string(&page)?;
        let path = page.strip_prefix(book)?.to_string_lossy().replace('\\', "/");
        for target in targets(&text).filter(|target| is_local(target)) {
            count += 1;
            if !book.join(join(&path, target)).exists() {
                broken.push(format!("{path}: {target}"));
            }
        }
    }
    ensure!(broken.is_empty(), "links of the book lead nowhere:\n{}", broken.join("\n"));
    Ok(count)
}

/// Returns what the attributes `href` and `src` of a page say.
fn targets(text: &str) -> impl Iterator<Item = &str> {
    let values = |name| text.split(name).skip(1).filter_map(|rest| rest.split('"').next());
    values(" href=\"").chain(values(" src=\""))
}

/// Tells whether a link leads to a file; within a page mdBook makes both ends.
fn is_local(target: &str) -> bool {
    let is_within = target.is_empty() || target.starts_with(['#', '/']);
    !(is_within || is_outside(target) || target.starts_with("data:"))
}

/// Returns all pages below a folder but the one for addresses that are not there, which the
/// root of a server shows.
fn pages(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut pages = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() {
            pages.extend(self::pages(&path)?);
        } else if path.extension().is_some_and(|e| e == "html") && !path.ends_with("404.html") {
            pages.push(path);
        }
    }
    Ok(pages)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_link_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
        write("a.html", r##"<a href="b.html#c"><img alt="" src="p.png"><a href="#d">"##);
        write("b.html", r#"<a href="https://a.b/c.html">"#);
        let error = check(folder.path()).unwrap_err();
        assert_eq!(format!("{error}"), "links of the book lead nowhere:\na.html: p.png");
        write("p.png", "");
        assert_eq!(check(folder.path()).unwrap(), 2);
    }
}
