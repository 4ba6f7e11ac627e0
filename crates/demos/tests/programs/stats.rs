//! `--check --stats`: what is in a file, whether or not it can be rendered.

use crate::common::Folder;
use serde_json::Value;

const BALL: &str = "m red =\n\trd 0.5\nv centre =\n\tp 0 0 1\nsph centre 0.5\n";

fn stats(folder: &Folder, arguments: &str) -> Value {
    let run = folder.run("bdpt", arguments);
    assert_eq!(run.status, Some(0), "{}", run.err);
    serde_json::from_str(&run.out).unwrap()
}

#[test]
fn a_scene_a_mesh_and_mgf_files_are_counted() {
    let folder = Folder::new();
    folder.write("ball.mgf", BALL);
    folder.write("more.mgf", "sph centre 2\n");
    assert_eq!(stats(&folder, "--check --stats - cornell")["primitives"], 15);
    let mesh = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/models/cube.3ds");
    assert_eq!(stats(&folder, &format!("--check {mesh} --stats -"))["faces"], 12);
    assert_eq!(stats(&folder, "--check ball.mgf --stats -")["surfaces"], 1);
    // The second file knows what the first has defined.
    let both = stats(&folder, "--check ball.mgf more.mgf --stats -");
    assert_eq!(both["by_kind"]["sph"], 2);
}

#[test]
fn figures_go_to_a_file_if_one_is_named() {
    let folder = Folder::new();
    folder.write("ball.mgf", BALL);
    let run = folder.run("trace", "--check ball.mgf --stats out.json");
    assert_eq!((run.status, run.out.as_str()), (Some(0), ""), "{}", run.err);
    assert!(folder.names().iter().any(|name| name == "out.json"));
}

#[test]
fn what_cannot_be_counted_is_told_with_its_place() {
    let folder = Folder::new();
    folder.write("bad.mgf", "\nsph nowhere 1\n");
    let run = folder.run("bdpt", "--check bad.mgf --stats -");
    assert_eq!((run.status, run.out.as_str()), (Some(3), ""));
    assert!(run.err.contains("bad.mgf:2: sph"), "{}", run.err);
    let run = folder.run("bdpt", "--check cornell pyramid --stats -");
    assert_eq!(run.status, Some(3));
    assert!(run.err.contains("only MGF files"), "{}", run.err);
    let run = folder.run("bdpt", "bad.mgf");
    assert_eq!(run.status, Some(3));
    assert!(run.err.contains("bad.mgf:2: sph"), "{}", run.err);
    assert_eq!(folder.run("bdpt", "cornell pyramid").status, Some(2));
    assert_eq!(folder.run("bdpt", "more.mgf bad.mgf --stats -").status, Some(2));
}
