//! What a page of Markdown links to.

use pulldown_cmark::{Event, Options, Parser, Tag};
use std::ops::Range;

/// A link, or the source of a picture.
#[derive(Debug, PartialEq)]
pub(super) struct Link {
    pub(super) target: String,
    /// Where it stands in the text, its words included.
    pub(super) range: Range<usize>,
}

/// Returns the links of a page in their order.
pub(super) fn links(text: &str) -> Vec<Link> {
    let events = Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter();
    let links = events.filter_map(|(event, range)| {
        let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event else {
            return None;
        };
        Some(Link { target: dest_url.into_string(), range })
    });
    links.collect()
}

/// Tells whether a link leads out of the project.
pub(super) fn is_outside(target: &str) -> bool {
    target.contains("://") || target.starts_with("mailto:")
}

/// Returns the path in the project of what a link on `page` leads to, without the heading there.
pub(super) fn join(page: &str, target: &str) -> String {
    let path = target.split('#').next().unwrap_or_default();
    if path.is_empty() {
        return page.to_string();
    }
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "." | "" => {}
            ".." => drop(parts.pop()),
            name => parts.push(name),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_and_pictures_are_found_with_their_places() {
        let text = "[a](b.md#c) and\n\n| `[x](y)` | ![p](q.png) |\n|---|---|\n";
        let found = links(text);
        let targets: Vec<&str> = found.iter().map(|link| link.target.as_str()).collect();
        assert_eq!(targets, ["b.md#c", "q.png"]);
        assert_eq!(&text[found[0].range.clone()], "[a](b.md#c)");
    }

    #[test]
    fn links_start_from_their_page() {
        assert_eq!(join("docs/a.md", "b.md#c"), "docs/b.md");
        assert_eq!(join("docs/howto/a.md", "../../scenes/"), "scenes");
        assert_eq!(join("README.md", "#here"), "README.md");
        assert!(is_outside("https://doc.rust-lang.org") && !is_outside("docs/a.md"));
    }
}
