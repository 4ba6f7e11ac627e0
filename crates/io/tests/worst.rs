//! MGF files made to take as much time and memory as the default bounds let them.
//!
//! Each is read in a process of its own, in release mode:
//! `cargo test --release -p traylib-io --test worst -- --ignored --nocapture`.
#![allow(clippy::print_stdout, reason = "figures for whoever changes a bound")]
#![allow(clippy::unwrap_used, reason = "a test may fail so, in its helpers too")]

#[path = "worst/cases.rs"]
mod cases;
#[path = "worst/measure.rs"]
mod measure;

use measure::{Measure, peak_kib};
use std::path::{Path, PathBuf};
use std::process::Command;
use traylib_io::mgf::{Options, Shape, decode, tessellate};

const MOST_SECONDS: f64 = 1.0;
const MOST_KIB: u64 = 256 << 10;

/// Names the file that the inner process reads.
const FILE: &str = "TRAYLIB_WORST_CASE";

#[test]
#[ignore = "a minute in release mode"]
fn the_worst_files_take_a_second_and_256_mib_at_most() {
    let folder = std::env::temp_dir().join(format!("traylib-worst-{}", std::process::id()));
    let only = std::env::var("TRAYLIB_ONLY").unwrap_or_default();
    let mut slow = Vec::new();
    for (name, write) in cases::ALL.into_iter().filter(|(name, _)| name.contains(&only)) {
        let folder = folder.join(name.replace(' ', "-"));
        std::fs::create_dir_all(&folder).unwrap();
        write(&folder);
        let (seconds, kib, end) = measured(&folder.join("a.mgf"));
        println!("{name:32} {seconds:6.3} s {:4} MiB  {end}", kib >> 10);
        if seconds > MOST_SECONDS || kib > MOST_KIB {
            slow.push(name);
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }
    let _ = std::fs::remove_dir_all(&folder);
    assert!(slow.is_empty(), "{slow:?}");
}

/// Seconds, peak memory in KiB, and how it ended.
fn measured(file: &Path) -> (f64, u64, String) {
    let mut inner = Command::new(std::env::current_exe().unwrap());
    inner.args(["--exact", "inner_process", "--nocapture"]).env(FILE, file);
    let output = inner.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let line = said.lines().find_map(|line| line.split_once("measured ")).map(|(_, rest)| rest);
    let mut parts = line.unwrap_or_else(|| panic!("{}: {said}", file.display())).splitn(3, ' ');
    let mut next = || parts.next().unwrap_or_default().to_string();
    (next().parse().unwrap(), next().parse().unwrap(), next())
}

/// The test that [`measured`] starts; alone it has nothing to do.
#[test]
fn inner_process() {
    let Some(file) = std::env::var_os(FILE).map(PathBuf::from) else { return };
    let measure = Measure::start();
    let end = match decode(&[file], &Options::default()) {
        Ok(document) => {
            let is_polygon =
                |shape: &Shape| matches!(shape, Shape::Face { .. } | Shape::Prism { .. });
            let polygons = document.surfaces.iter().filter(|surface| is_polygon(&surface.shape));
            let read = measure.seconds();
            let triangles: usize =
                polygons.map(|surface| tessellate::triangles(&surface.shape, 1).len()).sum();
            let surfaces = document.surfaces.len();
            format!("{surfaces} surfaces, {triangles} triangles of polygons, read in {read:.3} s")
        }
        Err(error) => error.to_string(),
    };
    println!("measured {:.3} {} {end}", measure.seconds(), peak_kib());
}
