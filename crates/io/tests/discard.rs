//! A program that ends at once leaves nothing beside its files. Alone in its process:
//! what is discarded is all that the process is writing.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on says so")]

use std::fs;
use std::time::{Duration, Instant};
use traylib_io::{discard_unfinished, write_file};

#[test]
fn what_is_being_written_is_discarded() {
    let folder = std::env::temp_dir().join(format!("traylib-discard-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.bin");
    let bytes = vec![7; 100 << 20];
    let names = || -> Vec<String> {
        let entries = fs::read_dir(&folder).unwrap().flatten();
        entries.map(|entry| entry.file_name().into_string().unwrap()).collect()
    };
    let outcome = std::thread::scope(|scope| {
        let writer = scope.spawn(|| write_file(&path, &bytes));
        let start = Instant::now();
        while names().is_empty() && start.elapsed() < Duration::from_mins(1) {
            std::thread::yield_now();
        }
        discard_unfinished();
        assert!(names().iter().all(|name| !name.contains(".part")), "{:?}", names());
        writer.join().unwrap()
    });
    // Whole, if the last step was done already.
    let is_whole = fs::read(&path).is_ok_and(|found| found == bytes);
    assert_eq!(is_whole, outcome.is_ok(), "{outcome:?}");
    fs::remove_dir_all(folder).unwrap();
}
