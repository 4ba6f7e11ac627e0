//! The table of contents is whole, and links lead somewhere.

use super::links::{is_outside, join, links};
use super::page::Page;
use super::summary;
use crate::workspace::root;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Returns the paths of all pages below a folder of the project.
fn pages_below(folder: &str) -> Vec<String> {
    let mut pages = Vec::new();
    for entry in fs::read_dir(root().join(folder)).unwrap() {
        let entry = entry.unwrap();
        let path = format!("{folder}/{}", entry.file_name().to_str().unwrap());
        if entry.path().is_dir() {
            pages.extend(pages_below(&path));
        } else if Path::new(&path).extension().is_some_and(|e| e == "md") {
            pages.push(path);
        }
    }
    pages
}

#[test]
fn the_book_has_every_page_once_and_none_that_is_not_there() {
    let named = summary::pages().unwrap();
    let mut below = pages_below("docs");
    below.retain(|page| page != summary::SUMMARY);
    assert!(below.len() > 20, "{below:?}");
    let left_out: Vec<_> = below.iter().filter(|page| !named.contains(page)).collect();
    assert!(left_out.is_empty(), "{} does not name {left_out:?}", summary::SUMMARY);
    for (number, page) in named.iter().enumerate() {
        assert!(root().join(page).is_file(), "{} names {page}", summary::SUMMARY);
        assert!(!named[..number].contains(page), "{} names {page} twice", summary::SUMMARY);
    }
}

/// What is wrong with the links of the pages, by page.
fn broken(pages: &BTreeMap<String, String>) -> Vec<String> {
    let mut broken = Vec::new();
    for (name, text) in pages {
        for link in links(text).iter().filter(|link| !is_outside(&link.target)) {
            let path = join(name, &link.target);
            let is_page = Path::new(&path).extension().is_some_and(|e| e == "md");
            let leads = match link.target.split_once('#') {
                Some((_, anchor)) => pages
                    .get(&path)
                    .is_some_and(|text| Page::of(text).anchors.iter().any(|other| other == anchor)),
                // A page that is not in the book could not be turned to.
                None if is_page => pages.contains_key(&path) || path == summary::SUMMARY,
                None => root().join(&path).exists(),
            };
            if !leads {
                broken.push(format!("{name}: {}", link.target));
            }
        }
    }
    broken
}

#[test]
fn links_lead_to_files_pages_of_the_book_and_headings() {
    let names = summary::pages().unwrap();
    let read = |name: String| {
        let text = fs::read_to_string(root().join(&name)).unwrap();
        (name, text)
    };
    let pages: BTreeMap<String, String> = names.into_iter().map(read).collect();
    assert_eq!(broken(&pages), Vec::<String>::new());
}

#[test]
fn links_that_lead_nowhere_are_found() {
    let text =
        "# Here\n[a](#here) [b](#there) [c](../scenes) [d](no.md) [e](no.png) [f](https://a.b)";
    let pages = BTreeMap::from([(String::from("docs/a.md"), text.to_string())]);
    assert_eq!(broken(&pages), ["docs/a.md: #there", "docs/a.md: no.md", "docs/a.md: no.png"]);
}
