//! `docs/seed-map.md` names files that exist.

use std::path::Path;

const FOLDERS: [&str; 2] = ["crates/", "scenes/"];

/// Everything between back ticks that is a path into one of [`FOLDERS`].
fn named_paths(text: &str) -> Vec<&str> {
    let spans = text.split('`').skip(1).step_by(2);
    spans.filter(|span| FOLDERS.iter().any(|folder| span.starts_with(folder))).collect()
}

#[test]
fn only_back_ticks_around_paths_count() {
    let text = "a `crates/a/src/b.rs` and `src/c`, crates/d.rs, `f()` then `scenes/e.ron`";
    assert_eq!(named_paths(text), ["crates/a/src/b.rs", "scenes/e.ron"]);
}

#[test]
fn every_file_of_the_seed_map_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let map = root.join("docs/seed-map.md");
    let text = std::fs::read_to_string(&map).expect("the seed map is part of the project");
    let paths = named_paths(&text);
    assert!(paths.len() > 10, "only {} paths found: has the notation changed?", paths.len());
    let missing: Vec<_> = paths.into_iter().filter(|path| !root.join(path).is_file()).collect();
    assert!(missing.is_empty(), "docs/seed-map.md names files that are not there: {missing:#?}");
}
