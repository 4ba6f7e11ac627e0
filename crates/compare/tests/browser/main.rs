//! The page in a browser: the wipe moves, nothing is asked for, nothing fails, and it
//! fits its window.
//!
//! Without a browser these tests say so and pass, unless `TRAYLIB_BROWSER` names one,
//! which then has to work.

#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod browser;
mod probe;

use browser::{Browser, Scheme};
use std::path::Path;
use traylib_compare::results::Results;
use traylib_compare::{page::page, sample::sample};

/// The window in which the page is looked at.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// In pixels of the style.
    width: u32,
    scheme: Scheme,
}

const WIDE_AND_LIGHT: Window = Window { width: 1200, scheme: Scheme::Light };
const NARROW_AND_DARK: Window = Window { width: 360, scheme: Scheme::Dark };

/// Returns the findings of the script in a page in a window; `None` without a browser.
fn probed(page: &str, window: Window) -> Option<probe::Findings> {
    let browser = Browser::find()?;
    let dump = browser.open(&probe::framed(&probe::into(page), window.width), window.scheme);
    Some(probe::Findings { complaints: dump.complaints, ..probe::Findings::read(&dump.document) })
}

fn sample_page() -> String {
    let (results, pictures) = sample();
    page(&results, &pictures)
}

fn check(page: &str, results: &Results, window: Window) {
    let Some(found) = probed(page, window) else { return };
    assert_eq!(found.errors, Vec::<String>::new());
    assert_eq!(found.complaints, Vec::<String>::new());
    assert_eq!(found.requests, Vec::<String>::new());
    assert_eq!(found.window, window.width);
    assert!(found.breadth <= found.window, "{} in a window of {}", found.breadth, found.window);
    assert_eq!(found.dark, window.scheme == Scheme::Dark);
    let methods: Vec<usize> = results.scenes.iter().map(|scene| scene.methods.len()).collect();
    assert!(!methods.is_empty());
    assert_eq!(found.lines, methods);
    assert_eq!(found.wipes.len(), methods.len());
    for wipe in &found.wipes {
        assert!(wipe.visible);
        assert_eq!(wipe.clips, ["inset(0px 50% 0px 0px)", "inset(0px 80% 0px 0px)"]);
        assert!(wipe.exchanged);
    }
    assert_eq!(found.broken_pictures, 0);
}

#[test]
fn wide_and_light() {
    check(&sample_page(), &sample().0, WIDE_AND_LIGHT);
}

#[test]
fn narrow_and_dark() {
    check(&sample_page(), &sample().0, NARROW_AND_DARK);
}

/// A page that the program has made, in the folder that `TRAYLIB_COMPARISON` names.
#[test]
#[allow(clippy::print_stderr, reason = "a test that is skipped has to say so")]
fn the_page_of_a_comparison() {
    let Some(folder) = std::env::var_os("TRAYLIB_COMPARISON") else {
        eprintln!("skipped: TRAYLIB_COMPARISON names no folder of a comparison");
        return;
    };
    let read = |name| std::fs::read_to_string(Path::new(&folder).join(name)).unwrap();
    let (page, results) = (read("index.html"), read("results.json"));
    let results: Results = serde_json::from_str(&results).unwrap();
    check(&page, &results, WIDE_AND_LIGHT);
    check(&page, &results, NARROW_AND_DARK);
}

#[test]
fn a_bad_page_is_found_out() {
    let bad = "<img src=\"https://nowhere.invalid/a.png\"><div style=\"width:5000px\">broad</div>\
        <script>throw new Error('by intention')</script></body>";
    let window = Window { width: 800, scheme: Scheme::Light };
    let page = sample_page().replacen("</body>", bad, 1);
    let Some(found) = probed(&page, window) else { return };
    for error in ["img-src", "by intention"] {
        assert!(found.errors.iter().any(|e| e.contains(error)), "{:?}", found.errors);
    }
    assert!(found.breadth >= 5000);
    assert!(!found.complaints.is_empty());
}

#[test]
fn charts_are_drawn_in_colours_for_the_window() {
    let page = sample_page();
    let paper = |scheme| probed(&page, Window { width: 800, scheme }).map(|f| f.first_line);
    let (light, dark) = (paper(Scheme::Light), paper(Scheme::Dark));
    if light.is_some() {
        assert_ne!(light, dark);
    }
}
