//! The page in a browser: the wipe moves, nothing is asked for, nothing fails, and it
//! fits its window.
//!
//! Without a browser these tests say so and pass, unless `TRAYLIB_BROWSER` names one,
//! which then has to work.

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

/// A sample page with a script that looks at it, in a window.
fn probed(window: Window) -> Option<probe::Findings> {
    let browser = Browser::find()?;
    let (results, pictures) = sample();
    let dump = browser.open(
        &probe::framed(&probe::into(&page(&results, &pictures)), window.width),
        window.scheme,
    );
    assert_eq!(dump.complaints, Vec::<String>::new());
    Some(probe::Findings::read(&dump.document))
}

fn check(window: Window) {
    let Some(found) = probed(window) else { return };
    assert_eq!(found.errors, Vec::<String>::new());
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
fn charts_are_drawn_in_colours_for_the_window() {
    let paper = |scheme| probed(Window { width: 800, scheme }).map(|f| f.first_line);
    let (light, dark) = (paper(Scheme::Light), paper(Scheme::Dark));
    if light.is_some() {
        assert_ne!(light, dark);
    }
}
