//! Damaged files of every format end in a result or a typed error, within a second and
//! 256 MiB, with the bounds that readers have by default.
//!
//! Real files, each damaged in 10,000 ways and cut off at up to 10,000 places:
//! `TRAYLIB_DATA=DIR cargo test --release -p traylib-io --test hostile -- --ignored real
//! --nocapture`; `TRAYLIB_SECONDS` bounds the time for each.
#![allow(clippy::print_stdout, reason = "says what was tried")]
#![allow(clippy::unwrap_used, reason = "a test may fail so, in its helpers too")]

#[path = "../src/texture/tests/made.rs"]
mod made;
#[path = "worst/measure.rs"]
mod measure;
#[path = "hostile/mutate.rs"]
mod mutate;
#[path = "hostile/readers.rs"]
mod readers;
#[path = "hostile/seeds.rs"]
mod seeds;

use measure::{Measure, peak_kib};
use mutate::{Mutations, beginnings};
use readers::read;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

const MOST_KIB: u64 = 256 << 10;

/// The results of reading the damaged copies of a file.
#[derive(Default)]
struct Summary {
    tried: usize,
    sound: usize,
    seconds: f64,
    kib: u64,
}

impl Summary {
    fn attempt(&mut self, root: &Path, name: &Path, bytes: &[u8]) {
        let measure = Measure::start();
        self.sound += usize::from(read(root, name, bytes));
        self.tried += 1;
        let (seconds, kib) = (measure.seconds(), peak_kib());
        // What is compiled without optimization may take longer.
        let most_seconds = if cfg!(debug_assertions) { 10.0 } else { 1.0 };
        if seconds > most_seconds || kib > MOST_KIB {
            let file = std::env::temp_dir().join("traylib-hostile").join(name);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(&file, bytes).unwrap();
            panic!("{seconds} s, {} MiB for {}", kib >> 10, file.display());
        }
        self.seconds = self.seconds.max(seconds);
        self.kib = self.kib.max(kib);
    }
}

/// Beginnings and mutations of a file, so many of each at most.
fn harass(root: &Path, name: &Path, bytes: &[u8], most: usize, until: Option<f64>) -> Summary {
    let (mut summary, start) = (Summary::default(), Instant::now());
    let mut mutations = Mutations::new(bytes, 7).take(most);
    let mut beginnings = beginnings(bytes, most);
    while until.is_none_or(|until| start.elapsed().as_secs_f64() < until) {
        let (mutation, beginning) = (mutations.next(), beginnings.next());
        if let Some(bytes) = &mutation {
            summary.attempt(root, name, bytes);
        }
        if let Some(bytes) = beginning {
            summary.attempt(root, name, bytes);
        }
        if mutation.is_none() && beginning.is_none() {
            break;
        }
    }
    summary
}

/// A folder of this process, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let name = format!("traylib-hostile-{name}-{}", std::process::id());
        let folder = Self(std::env::temp_dir().join(name));
        fs::create_dir_all(&folder.0).unwrap();
        Self(folder.0.canonicalize().unwrap())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn our_own_files_damaged() {
    let folder = Folder::new("own");
    for (name, bytes) in seeds::all() {
        assert!(read(&folder.0, Path::new(&name), &bytes), "{name} is not sound");
        let summary = harass(&folder.0, Path::new(&name), &bytes, 400, None);
        let Summary { tried, sound, .. } = summary;
        assert!(tried > 500 && (1..tried).contains(&sound), "{name}: {sound} of {tried}");
    }
}

#[test]
#[ignore = "long; real files"]
fn real_files_damaged() {
    let Some(data) = std::env::var_os("TRAYLIB_DATA").map(PathBuf::from) else {
        println!("skipped: TRAYLIB_DATA names no folder of real files");
        return;
    };
    let number = |name| std::env::var(name).ok().and_then(|text| text.parse::<f64>().ok());
    let until = number("TRAYLIB_SECONDS");
    let folder = Folder::new("real");
    let mut names = Vec::new();
    for part in ["3ds", "mgf", "textures", "pictures"] {
        copy(&data, Path::new(part), &folder.0, &mut names);
    }
    names.sort();
    let only = std::env::var("TRAYLIB_ONLY").unwrap_or_default();
    for name in names.iter().filter(|name| name.to_string_lossy().contains(&only)) {
        let bytes = fs::read(folder.0.join(name)).unwrap();
        let Summary { tried, sound, seconds, kib } = harass(&folder.0, name, &bytes, 10_000, until);
        let name = name.display();
        println!("{name}: {tried} tried, {sound} sound; at most {seconds:.3} s, {} MiB", kib >> 10);
    }
    assert!(!names.is_empty());
}

/// Copies a folder, and collects the names of the files that a reader knows.
fn copy(from: &Path, folder: &Path, to: &Path, names: &mut Vec<PathBuf>) {
    fs::create_dir_all(to.join(folder)).unwrap();
    for entry in fs::read_dir(from.join(folder)).unwrap() {
        let entry = entry.unwrap();
        let name = folder.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(from, &name, to, names);
            continue;
        }
        fs::copy(entry.path(), to.join(&name)).unwrap();
        let ending = name.extension().unwrap_or_default().to_ascii_lowercase();
        let known = ["mgf", "3ds", "obj", "ply", "gltf", "glb", "gif", "tga", "pcx", "png", "jpg"];
        if known.iter().any(|&known| ending == known) {
            names.push(name);
        }
    }
}

/// Writes the small pictures that fuzzing begins with, to the folder that
/// `TRAYLIB_SEEDS` names.
#[test]
#[ignore = "writes files"]
fn seeds_for_fuzzing() {
    let Some(folder) = std::env::var_os("TRAYLIB_SEEDS").map(PathBuf::from) else { return };
    fs::create_dir_all(&folder).unwrap();
    for (name, bytes) in seeds::textures() {
        fs::write(folder.join(name), bytes).unwrap();
    }
}
