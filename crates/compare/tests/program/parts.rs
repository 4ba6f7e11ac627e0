//! Runs that several processes share.

use crate::{Folder, SMALL, compare, err, program};
use std::collections::BTreeMap;
use std::process::{Child, Stdio};
use std::time::Duration;

/// Returns the files that are kept of runs and references, by name.
fn kept(out: &Folder) -> BTreeMap<String, Vec<u8>> {
    let files = ["references", "runs"].map(|folder| (folder, out.files(folder)));
    let path = |folder, name| format!("{folder}/{name}");
    let names = files.iter().flat_map(|(folder, names)| names.iter().map(|n| path(*folder, n)));
    names.map(|name| (name.clone(), std::fs::read(out.0.join(name)).unwrap())).collect()
}

fn start(out: &Folder, words: &str) -> Child {
    let words = words.split_whitespace().map(|word| word.replace('+', " "));
    program(&out.0).args(words).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Two machines without a common folder, and more parts than runs; which runs there are does not
/// depend on who makes them.
#[test]
fn parts_together_have_the_runs_of_the_whole() {
    let words = format!("furnace {SMALL}");
    let (whole, here, there) = (Folder::new("runs"), Folder::new("here"), Folder::new("there"));
    assert!(compare(&whole.0, &words).status.success());
    for part in [4, 0, 3, 1, 2] {
        let out = if part % 2 == 0 { &here } else { &there };
        let output = compare(&out.0, &format!("{words} --shard {part}/5"));
        assert!(output.status.success(), "{part}: {}", err(&output));
        assert!(String::from_utf8_lossy(&output.stdout).trim_end().ends_with("/runs"));
        assert!(!out.0.join("index.html").exists() && !out.0.join("results.json").exists());
    }
    for name in there.files("runs") {
        assert!(!here.0.join("runs").join(&name).exists(), "{name} was made twice");
        std::fs::copy(there.0.join("runs").join(&name), here.0.join("runs").join(&name)).unwrap();
    }
    let before = kept(&here);
    assert!(before.keys().eq(kept(&whole).keys()), "{:?}", before.keys());
    let output = compare(&here.0, &words);
    assert!(output.status.success(), "{}", err(&output));
    // No run was made any more, and the page has all of them.
    assert!(kept(&here) == before);
    assert_eq!(here.text("results.csv").lines().count(), 1 + 2 * 4);
    let results = here.results();
    assert!(results.complete);
    // The same files give the same numbers, whoever put them together in which order.
    assert!(compare(&there.0, &format!("{words} --shard 0/1")).status.success());
    for (name, bytes) in &before {
        std::fs::write(there.0.join(name), bytes).unwrap();
    }
    assert!(compare(&there.0, &words).status.success());
    assert_eq!(there.results().scenes[0].methods, results.scenes[0].methods);
    assert_eq!(there.text("results.csv"), here.text("results.csv"));
}

/// One reference for all: a part makes none of its own, and the whole finds it.
#[test]
fn parts_are_held_against_one_reference() {
    let out = Folder::new("parts");
    let words = format!("reference-a {SMALL} --quick");
    let output = compare(&out.0, &format!("{words} --shard 0/2"));
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    assert!(err(&output).contains("reference-a has no reference by this build in "));
    assert!(kept(&out).is_empty());
    let output = compare(&out.0, &format!("{words} --references-only"));
    assert!(output.status.success(), "{}", err(&output));
    let references = kept(&out);
    assert!(!references.is_empty() && references.keys().all(|n| n.starts_with("references/")));
    let parts = [0, 1].map(|part| start(&out, &format!("{words} --shard {part}/2")));
    for part in parts {
        let output = part.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", err(&output));
    }
    let all = kept(&out);
    assert_eq!(all.len(), references.len() + 2 * 4 * 2);
    assert!(references.iter().all(|(name, bytes)| all[name] == *bytes));
    assert!(compare(&out.0, &words).status.success());
    assert!(kept(&out) == all);
}

/// Killed each time that a file more is there, some moments later.
#[test]
fn a_part_that_is_killed_goes_on() {
    let (whole, out) = (Folder::new("quiet"), Folder::new("killed"));
    let words = format!("furnace {SMALL}");
    assert!(compare(&whole.0, &words).status.success());
    let runs = out.0.join("runs");
    let count = || std::fs::read_dir(&runs).map_or(0, Iterator::count);
    for kill in 0..6 {
        let before = count();
        let mut child = start(&out, &format!("{words} --shard 0/1"));
        while count() <= before && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(3 * kill));
        child.kill().unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(matches!(output.status.code(), None | Some(0)), "{}", err(&output));
    }
    let killed = kept(&out);
    let output = compare(&out.0, &format!("{words} --shard 0/1"));
    assert!(output.status.success(), "{}", err(&output));
    let all = kept(&out);
    assert!(all.keys().eq(kept(&whole).keys()), "{:?}", all.keys());
    // What had its numbers was whole, and stays.
    let numbers = |name: &str| std::path::Path::new(name).extension().is_some_and(|e| e == "json");
    let whole_before = killed.iter().filter(|(name, _)| numbers(name));
    assert!(whole_before.into_iter().all(|(name, bytes)| all[name] == *bytes));
    assert!(compare(&out.0, &words).status.success());
    assert!(kept(&out) == all);
}
