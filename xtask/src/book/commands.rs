//! Every command of the pages does what the page says: it is run, with few samples of a small
//! picture, or understood by the program that it is meant for. What can be neither stands in
//! [`unrun`], with the reason.
//!
//! A command is what a block of `sh` has on a line; the commands of a page run one after another,
//! in a folder with the files that pages speak of.
#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod files;
mod interpret;
mod programs;
mod shell;
mod small;
mod unrun;

use super::page::Page;
use super::summary;
use crate::workspace::root;
use interpret::Meaning;
use programs::Programs;
use shell::Command;
use std::collections::BTreeSet;
use std::path::Path;

/// Runs one command; what is wrong with it is an error.
fn attempt(command: &Command, programs: &Programs, folder: &Path) -> Result<(), String> {
    let words = shell::words(&command.text, folder)?;
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match interpret::meaning(&words)? {
        Meaning::Task => Ok(()),
        Meaning::Program { name, arguments } => {
            programs.run(name, &small::small(name, &arguments), folder)
        }
    }
}

/// Runs the commands of a page but those of [`unrun`], whose numbers are noted; what is wrong.
fn wrong(page: &str, text: &str, programs: &Programs, unrun: &mut BTreeSet<usize>) -> Vec<String> {
    let content = Page::of(text);
    let commands = shell::commands(&content);
    if commands.is_empty() {
        return Vec::new();
    }
    let folder = files::folder(programs);
    files::save_scenes(&content, folder.path());
    let mut wrong = Vec::new();
    for command in commands {
        if let Some(number) = unrun::number(&command.text) {
            unrun.insert(number);
        } else if let Err(error) = attempt(&command, programs, folder.path()) {
            wrong.push(format!("{page}:{}: `{}`: {error}", command.line, command.text));
        }
    }
    wrong
}

#[test]
fn every_command_of_the_book_works() {
    let programs = Programs::get();
    let (mut unrun, mut failures) = (BTreeSet::new(), Vec::new());
    for page in summary::pages().unwrap() {
        let text = std::fs::read_to_string(root().join(&page)).unwrap();
        failures.extend(wrong(&page, &text, programs, &mut unrun));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let stale: Vec<&str> = (0..unrun::UNRUN.len())
        .filter(|number| !unrun.contains(number))
        .map(|number| unrun::UNRUN[number].0)
        .collect();
    assert!(stale.is_empty(), "no page has these any more: {stale:?}");
}

#[test]
fn a_command_that_does_not_work_is_found() {
    let programs = Programs::get();
    for (command, complaint) in [
        ("cargo run --release --bin bdpt -- cornell --sppp 4", "--sppp"),
        ("cargo run --release --bin bdtp", "bdtp"),
        ("cargo run --bin bdpt cornell", "cornell"),
        ("bdpt no-such-scene", "no-such-scene"),
        ("bdpt cornell --max-depth 0", "max-depth"),
        ("bdpt cornell --resume", "--checkpoint"),
        ("film diff mine.exr", "required"),
        ("cargo xtask compare-integrators --quik", "--quik"),
        ("cargo xtask stability --scnee F10", "--scnee"),
        ("cargo xtask relations --scenes many", "many"),
        ("cargo xtask faults --edti SplatCosine", "no task"),
        ("cargo xtask polish", "no task"),
        ("realtime --methd bdpt", "--methd"),
        ("paint cornell", "paint"),
    ] {
        let page = format!("```sh\n{command}\n```\n");
        let found = wrong("page.md", &page, programs, &mut BTreeSet::new());
        assert!(found.len() == 1 && found[0].contains(complaint), "{command}: {found:?}");
    }
}

/// Tasks that are named within sentences.
#[test]
fn tasks_that_pages_name_are_tasks() {
    let mut named = 0;
    for page in summary::pages().unwrap() {
        let text = std::fs::read_to_string(root().join(&page)).unwrap();
        for span in Page::of(&text).spans.iter().filter(|span| span.starts_with("cargo xtask ")) {
            let words: Vec<&str> = span.split_whitespace().collect();
            assert!(interpret::meaning(&words).is_ok(), "{page}: {span}");
            named += 1;
        }
    }
    assert!(named > 20, "{named}");
}
