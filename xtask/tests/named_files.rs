//! The pages name files that exist.

use std::fs::read_to_string;
use std::path::{Path, PathBuf};

const FOLDERS: [&str; 6] = ["crates/", "docs/", "fuzz/", "scenes/", "tests/", "xtask/"];

/// Returns the texts between back ticks of a line.
fn spans(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

/// Tells whether it stands for a file that is to be made.
fn is_to_come(path: &str) -> bool {
    path.contains("NAME") || path.ends_with("/name.rs") || path == "name.rs"
}

fn is_path(span: &str) -> bool {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    (span.contains('/') || is_rust(span)) && span.chars().all(is_plain) && !is_to_come(span)
}

fn is_rust(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|ending| ending == "rs")
}

/// The paths of a page that are not in the project. A path either begins with one of
/// [`FOLDERS`], or is of Rust and the end of a path in the last folder that a sentence or the
/// head of a table above it in the same section named.
fn missing(page: &str, root: &Path) -> Vec<String> {
    let (mut missing, mut folder) = (Vec::new(), root.to_path_buf());
    let mut lines = page.lines().peekable();
    while let Some(line) = lines.next() {
        if line.starts_with("## ") {
            folder = root.to_path_buf();
        }
        for span in spans(line).filter(|span| is_path(span)) {
            let is_whole = FOLDERS.iter().any(|folder| span.starts_with(folder));
            let is_there = if is_whole {
                root.join(span).exists()
            } else {
                !(line.starts_with('|') || is_rust(span)) || holds(&folder, Path::new(span))
            };
            if !is_there {
                missing.push(span.to_string());
            }
        }
        let is_row = line.starts_with('|') && !lines.peek().is_some_and(|l| l.starts_with("|---"));
        let named = spans(line).filter(|span| span.ends_with('/') && is_path(span));
        if let Some(named) = named.map(|span| root.join(span)).find(|path| path.is_dir())
            && !is_row
        {
            folder = named;
        }
    }
    missing
}

/// Tells whether a folder, at any depth, has a path with this end.
fn holds(folder: &Path, end: &Path) -> bool {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.iter().any(|path| path.ends_with(end))
        || paths.iter().any(|path| path.is_dir() && !is_of_tools(path) && holds(path, end))
}

fn is_of_tools(path: &Path) -> bool {
    path.ends_with("target") || path.ends_with(".git")
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn only_back_ticks_around_paths_count() {
    let line = "a `crates/a/src/b.rs` and `Name::c`, crates/d.rs, `f()` then `scenes/e.ron`";
    let paths: Vec<&str> = spans(line).filter(|span| is_path(span)).collect();
    assert_eq!(paths, ["crates/a/src/b.rs", "scenes/e.ron"]);
}

#[test]
fn what_is_missing_is_found() {
    let page = "in `crates/math/src/`:\n| `rgb.rs`, `bgr.rs` |\n## Next\n`ci.rs`, `crates/ci.rs`";
    assert_eq!(missing(page, &root()), ["bgr.rs", "crates/ci.rs"]);
}

/// All pages but those of crates and scenes, which name files beside them.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![root().join("README.md"), root().join("CONTRIBUTING.md")];
    let mut folders = vec![root().join("docs")];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(folder)
            .expect("a folder of docs")
            .flatten()
            .map(|entry| entry.path());
        let (below, files): (Vec<PathBuf>, Vec<PathBuf>) = entries.partition(|path| path.is_dir());
        folders.extend(below);
        pages.extend(files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "md")));
    }
    pages
}

#[test]
fn every_file_that_a_page_names_exists() {
    let mut named = 0;
    for page in pages() {
        let text = read_to_string(&page).expect("a page");
        named += text.lines().flat_map(spans).filter(|span| is_path(span)).count();
        assert_eq!(missing(&text, &root()), Vec::<String>::new(), "{}", page.display());
    }
    assert!(named > 200, "only {named} paths: has the notation changed?");
}

/// The functions that a row of a table names behind a file of Rust, with that file:
/// `file.rs`: `Type::function`, `function`.
fn functions(line: &str) -> Vec<(&str, &str)> {
    let mut file = None;
    let mut functions = Vec::new();
    for span in spans(line).filter(|_| line.starts_with('|')) {
        if is_rust(span) {
            file = Some(span);
        } else if let Some(file) = file {
            functions.push((file, span));
        }
    }
    functions
}

/// Tells whether a text defines a function, and has a type of that name if one is named.
fn defines(text: &str, function: &str) -> bool {
    let (of, name) = function.rsplit_once("::").unwrap_or(("", function));
    let has = |start: &str| {
        let ends = |rest: &str| rest.starts_with(['(', '<', ' ', ';']);
        text.split(start).skip(1).any(ends)
    };
    let of_it = ["impl", "for"].iter().any(|word| has(&format!("{word} {of}")));
    has(&format!("fn {name}")) && (of.is_empty() || of_it || text.contains(&format!("> {of}")))
}

#[test]
fn functions_are_looked_for_in_their_files() {
    let row = "| `P` | `a.rs`: `A::b`, `c` |";
    assert_eq!(functions(row), [("a.rs", "A::b"), ("a.rs", "c")]);
    let text = "impl<'a> A<'a> {\n    fn b(&self) {}\n}\nfn c<T>() {}\n";
    assert!(["A::b", "b", "c"].iter().all(|function| defines(text, function)));
    assert!(["B::b", "d", "A::d"].iter().all(|function| !defines(text, function)));
}

#[test]
fn every_function_that_theory_names_is_in_its_file() {
    let page = read_to_string(root().join("docs/theory.md")).expect("a page");
    let mut named = 0;
    for (file, function) in page.lines().flat_map(functions) {
        let text = read_to_string(root().join(file)).expect("a file");
        assert!(defines(&text, function), "{file} has no {function}");
        named += 1;
    }
    assert!(named > 50, "{named}");
}
