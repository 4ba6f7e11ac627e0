//! Errors: one clear message with its place, the right status, nothing on
//! standard output, no file left behind.

use crate::common::{Folder, Run, SCENE, file, programs};
use std::process::Command;

/// Runs a program that must fail, and returns what it says.
#[track_caller]
fn fails(folder: &Folder, program: &str, arguments: &str, status: i32) -> String {
    let before = folder.names();
    let run = folder.run(program, arguments);
    assert_eq!(run.status, Some(status), "{program} {arguments}: {}", run.err);
    assert_eq!(run.out, "", "{program} {arguments}");
    assert_eq!(folder.names(), before, "{program} {arguments}");
    let errors = run.err.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 1, "{program} {arguments}: {}", run.err);
    run.err
}

/// Damages the scene and looks for the place and the words of the error.
#[track_caller]
fn scene_fails(from: &str, to: &str, place: &str, words: &str) {
    assert_eq!(SCENE.matches(from).count(), 1, "{from}");
    let folder = Folder::new();
    folder.write("bad.ron", &SCENE.replace(from, to));
    for program in programs() {
        let said = fails(&folder, program, "bad.ron --spp 1", 3);
        assert!(said.contains(&format!("--> bad.ron:{place}\n")), "{said}");
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn an_unknown_field() {
    scene_fails("radius: 1", "radios: 1", "5:43", "did you mean `radius`?");
}

#[test]
fn a_material_that_is_not_there() {
    let to = "), material: \"gray\"),";
    scene_fails("), material: \"grey\"),", to, "5:65", "did you mean `grey`?");
}

#[test]
fn a_lamp_without_area() {
    scene_fails("edge_v: (0, 0, 2)", "edge_v: (4, 0, 0)", "6:17", "has no area");
}

#[test]
fn a_material_that_reflects_more_than_arrives() {
    let to = "Phong(diffuse: (0.5, 0, 0), specular: (0.6, 0, 0), exponent: 5)";
    scene_fails("Lambert(reflectance: (0.5, 0.5, 0.5))", to, "3:26", "up to 1.1");
}

#[test]
fn a_coordinate_that_is_no_number() {
    scene_fails("center: (0, 0, 0)", "center: (0, NaN, 0)", "5:32", "not a number");
}

#[test]
fn a_mesh_that_is_not_there() {
    let from = "Sphere(center: (0, 0, 0), radius: 1)";
    scene_fails(from, "Mesh(file: \"no.3ds\")", "5:28", "no.3ds cannot be used");
}

#[test]
fn a_text_that_ends_too_early() {
    scene_fails("    ],\n)", "", "4:14", "`[` is not closed");
}

#[test]
fn a_scene_that_is_not_there() {
    let said = fails(&Folder::new(), "bdpt", "cornel", 3);
    assert!(said.contains("did you mean `cornell`?") && said.contains("`furnace`"), "{said}");
}

#[test]
fn a_scene_that_is_no_text() {
    let folder = Folder::new();
    std::fs::write(folder.path().join("bad.ron"), b"(\xff\xfe)").unwrap();
    let said = fails(&folder, "bdpt", "bad.ron", 3);
    assert!(said.contains("bad.ron: cannot be read: it is not UTF-8 text"), "{said}");
}

/// `--check` finds what would end a rendering, and makes nothing.
#[test]
fn a_check_fails_where_the_rendering_would() {
    let folder = Folder::new();
    folder.write("file", "");
    folder.write("ball.mgf", "v c =\n\tp 0 0 1\nm grey =\n\trd .5\nsph c .5\n");
    for (arguments, status, words) in [
        ("cornell -o no/such/a.exr", 4, "no/such/a.exr: cannot be written: "),
        ("cornell -o a.png -o file/b.png", 4, "file/b.png: cannot be written: "),
        ("cornell -o a.gif", 2, "a.gif: pictures are written as "),
        ("cornell -o a.hdr --resolution 32768x1", 4, "at most 32767 columns and "),
        ("cornell --techniques file/t", 4, "file/t: cannot be written to: file takes no files"),
        ("cornell --roulette off", 2, "wants a --max-depth"),
        ("cornell --pixel 400,3", 2, "outside the 400x300 picture"),
        ("ball.mgf", 3, "nothing in it emits light"),
    ] {
        for arguments in [format!("{arguments} --check"), format!("{arguments} --time-limit 1h")] {
            let said = fails(&folder, "bdpt", &arguments, status);
            assert!(said.contains(words), "{arguments}: {said}");
        }
    }
    let before = folder.names();
    let run = folder.run("bdpt", "cornell --check --techniques a/b -o a.exr");
    assert_eq!((run.status, folder.names()), (Some(0), before), "{}", run.err);
}

/// Below a plain file there is no folder, whoever asks.
#[test]
fn outputs_that_cannot_be_written_are_found_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    let hour = "cornell --time-limit 1h";
    for output in ["-o file/a.png", "-o no/such/a.exr", "-o a.png -o file/b.png"] {
        let said = fails(&folder, "bdpt", &format!("{hour} {output}"), 4);
        assert!(said.contains(".png: cannot be written") || said.contains("a.exr: "), "{said}");
    }
    let said = fails(&folder, "bdpt", &format!("{hour} --techniques file/techniques"), 4);
    assert!(said.contains("techniques: cannot be written to: file takes no files"), "{said}");
    std::fs::create_dir(folder.path().join("a.png")).unwrap();
    let said = fails(&folder, "bdpt", &format!("{hour} -o a.png"), 4);
    assert!(said.contains("a.png: cannot be written: it is a folder"), "{said}");
}

#[test]
fn command_lines_that_make_no_sense() {
    let folder = Folder::new();
    for (arguments, words) in [
        ("-o a.jpg", "a.jpg: pictures are written as .png, .exr,"),
        ("-o a", "a: pictures are written as .png, .exr,"),
        ("--spp 0", "'--spp <N>'"),
        ("--threads 1000000", "wanted a number from 0, one a processor, to 1024"),
        ("--resolution 100000x100000", "wanted as 640x480"),
        ("--max-depth 0", "'--max-depth <N>'"),
        ("--resolution 0x5", "wanted as 640x480"),
        ("--resolution 32768x32768", "wanted as 640x480"),
        ("--time-limit 5", "with its unit"),
        ("--roulette 1", "an edge from 2 on"),
        ("--roulette off", "wants a --max-depth"),
        ("--limit faces=3", "names: bytes, memory,"),
        ("--pixel 400,3", "outside the 400x300 picture"),
        ("--pixel 3", "wanted as X,Y"),
        ("--pixel 1,1 --techniques d", "cannot be used with"),
        ("--pixel 1,1 -o a.png", "cannot be used with"),
        ("--colour", "unexpected argument '--colour'"),
    ] {
        let said = fails(&folder, "bdpt", arguments, 2);
        assert!(said.contains(words), "{arguments}: {said}");
    }
}

/// The first may have half a gigabyte, and no machine has what the last wants.
#[test]
#[cfg(target_os = "linux")]
fn a_picture_that_does_not_fit_into_memory() {
    let folder = Folder::new();
    for program in programs() {
        let file = file(program);
        let file = file.display();
        for more in ["", " --check"] {
            let script = format!(
                "ulimit -v 500000; exec {file} cornell --resolution 4000x4000 --spp 1 -q{more}"
            );
            let mut shell = Command::new("sh");
            let run =
                Run::from(shell.current_dir(folder.path()).args(["-c", &script]).output().unwrap());
            assert_eq!((run.status, run.out.as_str()), (Some(4), ""), "{program}: {}", run.err);
            let words = "error: 4000x4000 pixels need about ";
            assert!(run.err.starts_with(words) && run.err.lines().count() == 1, "{}", run.err);
        }
    }
    let all = "cornell --resolution 16384x16384 --techniques t --spp 5 -q";
    let said = fails(&folder, "bdpt", all, 4);
    assert!(said.contains("3797.82 GB of memory, 14148 bytes each"), "{said}");
}

#[test]
fn what_was_there_stays_when_nothing_new_can_be_made() {
    let folder = Folder::new();
    folder.write("bdpt.png", "old");
    fails(&folder, "bdpt", "no-such-scene", 3);
    assert_eq!(std::fs::read(folder.path().join("bdpt.png")).unwrap(), b"old");
}
