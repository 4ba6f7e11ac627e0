//! The methods against one another on scenes that others made, where the environment
//! variable `TRAYLIB_DATA` names the folder they are in; how, stands in
//! `traylib_tests::agreement`. What only rare chance finds is masked and counted
//! there: small lamps seen in chrome, or through two panes.

use std::path::PathBuf;
use traylib_io::{LoadOptions, load_scene_with};
use traylib_tests::agreement::{Budget, Other, Subject, agree};
use traylib_tests::findings::settle;
use traylib_tests::methods::COMBINED;

/// `directlight --combine` against `bdpt`, to within `promise` of the mean.
fn combined_agrees(name: &str, file: &str, passes: u32, promise: f64) {
    let Some(folder) = std::env::var_os("TRAYLIB_DATA").map(PathBuf::from) else {
        println!("{name}: skipped, TRAYLIB_DATA names no folder");
        return;
    };
    let (root, file) = (folder.join("mgf"), folder.join("mgf").join(file));
    let options =
        LoadOptions { resolution: Some((64, 48)), root: Some(&root), ..LoadOptions::default() };
    let scene = load_scene_with(file.to_str().unwrap(), options).unwrap().scene;
    let budget = Budget { tile: 8, looks: vec![passes / 4, passes] };
    let others = [Other { method: COMBINED, passes: 4, promise }];
    let agreement = agree(&Subject { name, scene: &scene }, &others, &budget);
    for finding in &agreement.findings {
        println!("{}: {}", finding.claim, finding.statistic);
    }
    settle(&agreement.findings);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_office() {
    combined_agrees("office", "radsite/office.mgf", 1024, 0.02);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_conf() {
    combined_agrees("conf", "radsite/conf.mgf", 1024, 0.02);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_soda() {
    combined_agrees("soda", "radsite/soda.mgf", 1024, 0.02);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_bathroom() {
    combined_agrees("bathroom", "radsite/bathroom.mgf", 1024, 0.05);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn on_hospital() {
    combined_agrees("hospital", "renderpark/hospital/hosp.mgf", 1024, 0.05);
}
