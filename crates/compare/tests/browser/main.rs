//! The page in a browser: the wipe moves, nothing is asked for, nothing fails, and it
//! fits its window.
//!
//! Without a browser these tests say so and pass, unless `TRAYLIB_BROWSER` names one,
//! which then has to work.

#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod browser;
mod probe;

use browser::{Browser, Scheme};
use traylib_compare::{page::page, sample::sample};

/// Where the page is looked at.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// In pixels of the style.
    width: u32,
    scheme: Scheme,
}

/// What a script finds in the sample page, changed a little, in a window.
fn probed(window: Window, change: impl FnOnce(&str) -> String) -> Option<probe::Findings> {
    let browser = Browser::find()?;
    let (results, pictures) = sample();
    let page = probe::into(&change(&page(&results, &pictures)));
    let dump = browser.open(&probe::framed(&page, window.width), window.scheme);
    Some(probe::Findings { complaints: dump.complaints, ..probe::Findings::read(&dump.document) })
}

fn check(window: Window) {
    let Some(found) = probed(window, str::to_owned) else { return };
    assert_eq!(found.errors, Vec::<String>::new());
    assert_eq!(found.complaints, Vec::<String>::new());
    assert_eq!(found.requests, Vec::<String>::new());
    assert_eq!(found.window, window.width);
    assert!(found.breadth <= found.window, "{} in a window of {}", found.breadth, found.window);
    assert_eq!(found.dark, window.scheme == Scheme::Dark);
    assert_eq!(found.lines, sample().0.scenes.iter().map(|s| s.methods.len()).collect::<Vec<_>>());
    assert_eq!(found.wipes.len(), 2);
    for wipe in &found.wipes {
        assert!(wipe.visible);
        assert_eq!(wipe.clips, ["inset(0px 50% 0px 0px)", "inset(0px 80% 0px 0px)"]);
        assert!(wipe.exchanged);
    }
    assert_eq!(found.broken_pictures, 0);
}

#[test]
fn wide_and_light() {
    check(Window { width: 1200, scheme: Scheme::Light });
}

#[test]
fn narrow_and_dark() {
    check(Window { width: 360, scheme: Scheme::Dark });
}

#[test]
fn a_bad_page_is_found_out() {
    let bad = "<img src=\"https://nowhere.invalid/a.png\"><div style=\"width:5000px\">broad</div>\
        <script>throw new Error('by intention')</script></body>";
    let window = Window { width: 800, scheme: Scheme::Light };
    let Some(found) = probed(window, |page| page.replacen("</body>", bad, 1)) else { return };
    for error in ["img-src", "by intention"] {
        assert!(found.errors.iter().any(|e| e.contains(error)), "{:?}", found.errors);
    }
    assert!(found.breadth >= 5000);
    assert!(!found.complaints.is_empty());
}

#[test]
fn charts_are_drawn_in_colours_for_the_window() {
    let paper = |scheme| probed(Window { width: 800, scheme }, str::to_owned).map(|f| f.first_line);
    let (light, dark) = (paper(Scheme::Light), paper(Scheme::Dark));
    if light.is_some() {
        assert_ne!(light, dark);
    }
}
