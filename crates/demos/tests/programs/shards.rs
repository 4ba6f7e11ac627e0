//! Renderings in parts.

use crate::common::{Dice, Folder, MODES, files};
use std::process::Stdio;
use std::time::Duration;
use traylib_io::{load_film, save_film};

const SIZE: &str = "spheres --resolution 16x12 --spp 23 -q";

/// Renders all parts, some of them in several runs, and merges them in some order.
fn merged(folder: &Folder, program: &str, rendering: &str, parts: u32, dice: &mut Dice) {
    let mut files: Vec<String> = (0..parts).map(|part| format!("{part}.film")).collect();
    for (part, file) in files.iter().enumerate() {
        let options = format!("{rendering} --shard {part}/{parts} --checkpoint {file}");
        match dice.below(6) {
            0 => {
                // It may be too short for a pass.
                let run = folder.run(program, &format!("{options} --time-limit 0.03s"));
                assert!(matches!(run.status, Some(0 | 4)), "{}", run.err);
            }
            1 => {
                let often = "--checkpoint-every 0.001s";
                let mut child = folder.command(program, &format!("{options} {often}"));
                let mut child = child.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
                std::thread::sleep(Duration::from_millis(dice.below(60)));
                child.kill().unwrap();
                child.wait().unwrap();
            }
            _ => {}
        }
        let run = folder.run(program, &format!("{options} --resume"));
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{program} {rendering}");
        assert_eq!(run.out, format!("{file}\n"));
    }
    for place in (1..files.len()).rev() {
        files.swap(place, dice.below(place as u64 + 1) as usize);
    }
    let run = folder.run("film", &format!("merge -o all.film {}", files.join(" ")));
    assert_eq!((run.status, run.out.as_str()), (Some(0), "all.film\n"), "{}", run.err);
}

/// Renders a whole, and again in so many parts each time: all files have the same bytes, those
/// that the program makes of the merged film and those that `film` does.
fn parts_make_the_whole(program: &str, rendering: &str, counts: &[u32], dice: &mut Dice) {
    let whole = Folder::new();
    let outputs = "--checkpoint all.film -o a.exr -o a.png";
    let run = whole.run(program, &format!("{rendering} {outputs}"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{program} {rendering}");
    let mut expected = files(whole.path());
    expected.remove("all.film.previous");
    for &parts in counts {
        let what = format!("{program} {rendering} in {parts} parts");
        let folder = Folder::new();
        merged(&folder, program, rendering, parts, dice);
        assert!(folder.bytes("all.film") == expected["all.film"], "{what}");
        for picture in ["a.exr", "a.png"] {
            let run = folder.run("film", &format!("convert all.film {picture}"));
            assert_eq!(run.status, Some(0), "{}", run.err);
            assert!(folder.bytes(picture) == expected[picture], "{what}: {picture}");
        }
        let run = folder.run(program, &format!("{rendering} {outputs} --resume"));
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{what}");
        let found = files(folder.path());
        for (name, bytes) in &expected {
            assert!(found[name] == *bytes, "{what}: {name}");
        }
    }
}

#[test]
fn parts_make_the_bytes_of_the_whole() {
    let mut dice = Dice(3);
    for (program, mode) in MODES {
        let many = if mode.contains("sobol --max") { 100 } else { 11 };
        parts_make_the_whole(program, &format!("{SIZE} {mode}"), &[1, 2, 3, 7, many], &mut dice);
    }
}

/// Some minutes: no part is empty.
#[test]
#[ignore = "long"]
fn a_hundred_parts_make_the_bytes_of_the_whole() {
    let mut dice = Dice(100);
    let size = "spheres --resolution 48x36 -q";
    for (program, mode) in MODES {
        let rendering = format!("{size} --spp 131 {mode}");
        parts_make_the_whole(program, &rendering, &[1, 2, 3, 7, 100], &mut dice);
    }
}

/// A plan is made once, and handed to all parts; or each makes it anew, and it is the same.
#[test]
fn parts_by_a_plan_make_the_bytes_of_the_whole() {
    let size = "plates --resolution 96x72 --spp 64 -q";
    let planned = Folder::new().run("bdpt", &format!("{size} --auto --explain json --check"));
    let end = planned.out.rfind('}').unwrap();
    let plan: serde_json::Value = serde_json::from_str(&planned.out[..=end]).unwrap();
    let plan = plan["plan"].as_str().unwrap();
    let whole = Folder::new();
    let run = whole.run("bdpt", &format!("{size} --auto --checkpoint all.film -o a.exr"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    let folder = Folder::new();
    for (part, how) in
        [["--plan", plan].as_slice(), &["--auto"], &["--plan", plan]].iter().enumerate()
    {
        let options = format!("{size} --shard {part}/3 --checkpoint {part}.film");
        let output = folder.command("bdpt", &options).args(*how).output().unwrap();
        assert!(output.status.success(), "{how:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
    assert_eq!(folder.run("film", "merge 1.film 2.film 0.film -o all.film").status, Some(0));
    assert!(folder.bytes("all.film") == whole.bytes("all.film"));
}

#[test]
fn missing_and_doubled_parts_are_named() {
    let folder = Folder::new();
    for part in 0..5 {
        let file = format!("--shard {part}/5 --checkpoint {part}.film");
        assert_eq!(folder.run("puremc", &format!("{SIZE} {file}")).status, Some(0));
    }
    let other = "--seed 1 --shard 1/5 --checkpoint other.film";
    assert_eq!(folder.run("puremc", &format!("{SIZE} {other}")).status, Some(0));
    for (films, words) in [
        (
            "4.film 0.film 2.film",
            "error: 10 of 23 passes are missing: 4 to 8, 13 to 17; part 1/5 is missing; part 3/5 is missing\n",
        ),
        (
            "0.film 1.film 2.film 3.film 1.film 4.film",
            "error: 1.film: has pass 4, and so has 1.film\n",
        ),
        ("0.film other.film", "error: other.film: does not fit to 0.film: its seed is 1, not 0\n"),
    ] {
        let run = folder.run("film", &format!("merge {films} -o all.film"));
        assert_eq!((run.status, run.out.as_str()), (Some(6), ""), "{}", run.err);
        assert_eq!(run.err, words);
        assert!(!folder.path().join("all.film").exists());
    }
    let run = folder.run("film", "merge 4.film 0.film 2.film --partial -o some.film");
    assert_eq!((run.status, run.out.as_str()), (Some(0), "some.film\n"));
    assert!(run.err.starts_with("warning: 10 of 23 passes are missing"), "{}", run.err);
    let run = folder.run("film", "merge some.film 1.film 3.film -o all.film");
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    assert_eq!(load_film(&folder.path().join("all.film")).unwrap().0.passes(), 23);
}

/// One that was cut off by the clock.
#[test]
fn parts_that_are_not_complete_are_named() {
    let folder = Folder::new();
    for part in 0..2 {
        let file = format!("--shard {part}/2 --checkpoint {part}.film");
        assert_eq!(folder.run("puremc", &format!("{SIZE} {file}")).status, Some(0));
    }
    let path = folder.path().join("1.film");
    let (whole, about) = load_film(&path).unwrap();
    let mut cut = traylib_scene::Film::of_sequences(16, 12, 2);
    // Of the first sequence: passes 12 and 14.
    let first = whole.sequences().next().unwrap().next().unwrap().clone();
    cut.add_block(0, first).unwrap();
    save_film(&path, None, &cut, &about).unwrap();
    let run = folder.run("film", "merge 1.film 0.film -o all.film");
    let words = "error: 10 of 23 passes are missing: 11, 13, 15 to 22; part 1/2 has 2 of \
                 12 passes\n";
    assert_eq!((run.status, run.err.as_str()), (Some(6), words));
}

#[test]
fn films_say_what_they_are_of() {
    let folder = Folder::new();
    let run = folder.run("bdpt", &format!("{SIZE} --seed 7 --shard 1/3 --checkpoint a.film"));
    assert_eq!(run.status, Some(0), "{}", run.err);
    let said = folder.run("film", "info a.film").out;
    for words in [
        "a.film: film of 16x12 pixels\n  8 passes: 7 to 14\n",
        "    method = bdpt\n",
        "    seed = 7\n",
        "    spp = 23\n    shard = 1/3\n",
        "    camera paths = 1536\n",
        " --seed 7 ",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&folder.run("film", "info a.film --json").out).unwrap();
    assert_eq!(json[0]["passes"], serde_json::json!([[7, 15]]));
    assert_eq!(json[0]["counters"]["camera paths"], 1536);
}

#[test]
fn a_queue_hears_how_far_it_is() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "cornell --resolution 8x6 --spp 1 -q --progress openjd -o a.exr");
    let said = "openjd_progress: 100.0\nopenjd_status: 1 spp are done, 00:00 left\na.exr\n";
    assert_eq!((run.status, run.out.as_str()), (Some(0), said), "{}", run.err);
}

#[test]
fn what_cannot_be_kept_is_refused() {
    let folder = Folder::new();
    for (program, options) in [
        ("bdpt", "--shard 0/2"),
        ("bdpt", "--resume"),
        ("bdpt", "--checkpoint a.film --shard 2/2"),
        ("bdpt", "--checkpoint a.film --shard 0/2 -o a.png"),
        ("bdpt", "--checkpoint a.film --shard 0/2 --time-limit 1s"),
        ("bdpt", "--checkpoint a.film --pixel 1,1"),
        ("film", "merge a.film -o a.exr"),
    ] {
        let run = folder.run(program, options);
        assert_eq!((run.status, folder.names().len()), (Some(2), 0), "{options}: {}", run.err);
    }
}
