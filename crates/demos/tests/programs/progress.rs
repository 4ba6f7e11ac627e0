//! `--progress` and `--stats`: what other programs are told.

use crate::common::{Folder, programs};
use serde_json::Value;

#[test]
fn lines_of_json_tell_how_far_it_is() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "cornell --resolution 8x6 --spp 3 -q --progress json -o a.exr");
    assert_eq!(run.status, Some(0), "{}", run.err);
    let lines: Vec<&str> = run.out.lines().collect();
    let (file, told) = lines.split_last().unwrap();
    assert_eq!(*file, "a.exr");
    let told: Vec<Value> = told.iter().map(|line| serde_json::from_str(line).unwrap()).collect();
    let last = told.last().unwrap();
    assert_eq!((&last["percentDone"], &last["spp"]), (&100.0.into(), &3.into()));
    for line in &told {
        assert!(line["totalClockTime"].as_f64().unwrap() > 0.0, "{line}");
    }
}

#[test]
fn every_program_says_what_it_has_done() {
    let folder = Folder::new();
    for program in programs() {
        let scene = if program == "trace" { "spheres" } else { "cornell" };
        let words = format!("{scene} --resolution 8x6 --spp 2 --seed 5 -q --stats - -o a.png");
        let run = folder.run(program, &words);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let json = run.out.strip_prefix("a.png\n").unwrap();
        let stats: Value = serde_json::from_str(json).unwrap();
        assert_eq!((&stats["program"], &stats["spp"]), (&program.into(), &2.into()));
        assert_eq!(stats["endedBy"], "--spp");
        assert!(stats["command"].as_str().unwrap().ends_with("--spp 2"), "{json}");
        let rays = ["camera", "bounce", "shadow"].map(|kind| stats["rays"][kind].as_u64().unwrap());
        assert!(rays.iter().sum::<u64>() > 48, "{json}");
    }
}

#[test]
fn where_it_cannot_be_said_nothing_is_rendered() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "cornell --resolution 8x6 --spp 2 --stats nowhere/a.json");
    assert_eq!(run.status, Some(4), "{}", run.err);
    assert!(run.err.contains("nowhere"), "{}", run.err);
    assert!(folder.names().is_empty());
}
