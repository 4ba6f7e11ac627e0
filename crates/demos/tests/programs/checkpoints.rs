//! Renderings that are interrupted, and go on.

use crate::common::{Folder, MODES, Run, SCENE, files};
use std::collections::BTreeMap;
use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use traylib_io::{load_film, save_film};

const SIZE: &str = "spheres --resolution 24x18 -q -o a.exr -o a.png";

/// Returns the files of a run that nothing disturbs, but for the checkpoint before the last.
pub(crate) fn undisturbed(program: &str, options: &str) -> BTreeMap<String, Vec<u8>> {
    let folder = Folder::new();
    let run = folder.run(program, &format!("{options} --checkpoint a.film"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{program} {options}");
    without_previous(files(folder.path()))
}

fn without_previous(mut files: BTreeMap<String, Vec<u8>>) -> BTreeMap<String, Vec<u8>> {
    files.remove("a.film.previous");
    files
}

#[track_caller]
pub(crate) fn assert_same(
    found: BTreeMap<String, Vec<u8>>,
    expected: &BTreeMap<String, Vec<u8>>,
    what: &str,
) {
    let found = without_previous(found);
    assert!(found.keys().eq(expected.keys()), "{what}: {:?}", found.keys());
    let differ: Vec<_> = found.keys().filter(|name| found[*name] != expected[*name]).collect();
    assert!(differ.is_empty(), "{what}: {differ:?}");
}

/// In steps of a few passes, each a run of its own, pictures of the passes so far included.
#[test]
fn many_short_runs_leave_the_bytes_of_one() {
    for (program, mode) in MODES {
        let options = format!("{SIZE} {mode}");
        let expected = undisturbed(program, &format!("{options} --spp 11"));
        let folder = Folder::new();
        for spp in [2, 3, 8, 8, 11] {
            let run =
                folder.run(program, &format!("{options} --spp {spp} --checkpoint a.film --resume"));
            assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{program} {mode} {spp}");
        }
        assert_same(files(folder.path()), &expected, &format!("{program} {mode}"));
    }
}

/// Waits until a program has written its first checkpoint, or has ended.
fn wait_for_checkpoint(folder: &Folder, child: &mut Child) {
    while !folder.path().join("a.film").exists() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn signal(name: &str, child: &Child) {
    let kill = Command::new("kill").args(["-s", name, &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
}

#[test]
fn a_run_that_is_told_to_end_keeps_what_it_has() {
    const OPTIONS: &str = "cornell --resolution 40x30 -o a.exr --checkpoint a.film --resume";
    for (name, status) in [("TERM", 143), ("INT", 130), ("HUP", 129)] {
        let folder = Folder::new();
        let mut child = folder.command("bdpt", &format!("{OPTIONS} --spp 1000000"));
        let mut child = child.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        wait_for_checkpoint(&folder, &mut child);
        std::thread::sleep(Duration::from_millis(100));
        signal(name, &child);
        let run = Run::from(child.wait_with_output().unwrap());
        assert_eq!(run.status, Some(status), "{}", run.err);
        let done = load_film(&folder.path().join("a.film")).unwrap().0.passes();
        assert!(run.err.contains(&format!("what is written has {done} spp")), "{}", run.err);
        let run = folder.run("bdpt", &format!("{OPTIONS} --spp {}", done + 3));
        assert_eq!(run.status, Some(0), "{}", run.err);
        let said = format!("going on from a.film: {done} of {} passes are done\n", done + 3);
        assert!(run.err.contains(&said), "{}", run.err);
        let said = format!("bdpt cornell: {} spp, {done} of them before, in ", done + 3);
        assert!(run.err.contains(&said), "{}", run.err);
        let all = format!("cornell --resolution 40x30 -o a.exr -q --spp {}", done + 3);
        assert_same(files(folder.path()), &undisturbed("bdpt", &all), name);
    }
}

/// A clock of its own for every run; the checkpoint is written at its end, too.
#[test]
fn a_time_limit_keeps_what_there_is() {
    let folder = Folder::new();
    let options = "cornell --resolution 16x12 -q -o a.exr --checkpoint a.film --resume";
    let mut last = 0;
    for _ in 0..3 {
        let run = folder.run("puremc", &format!("{options} --time-limit 0.3s"));
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
        let done = load_film(&folder.path().join("a.film")).unwrap().0.passes();
        assert!(done > last, "{done} {last}");
        last = done;
    }
    let all = format!("cornell --resolution 16x12 -q -o a.exr --spp {last}");
    let expected = undisturbed("puremc", &all);
    assert_eq!(folder.bytes("a.exr"), expected["a.exr"]);
}

#[test]
fn what_is_complete_is_written_and_done() {
    let folder = Folder::new();
    let options = "cornell --resolution 16x12 --spp 3 -o a.png --checkpoint a.film";
    assert_eq!(folder.run("puremc", options).status, Some(0));
    let before = folder.bytes("a.png");
    let film = folder.bytes("a.film");
    fs::remove_file(folder.path().join("a.png")).unwrap();
    let run = folder.run("puremc", &format!("{options} --resume"));
    assert_eq!((run.status, run.out.as_str()), (Some(0), "a.png\n"), "{}", run.err);
    assert!(run.err.contains("a.film: 3 of 3 passes are done\n"), "{}", run.err);
    assert!(folder.bytes("a.png") == before && folder.bytes("a.film") == film);
    // Nobody loses hours because they forgot a word.
    let run = folder.run("puremc", options);
    assert_eq!(run.status, Some(2));
    assert!(
        run.err
            .contains("error: a.film: there is a checkpoint already; go on from it with --resume")
    );
    assert!(folder.bytes("a.film") == film);
}

/// One line, a status of its own, and the file as it was.
#[test]
fn another_rendering_is_refused_by_what_differs() {
    let folder = Folder::new();
    let run = folder.run(
        "puremc",
        "cornell --resolution 16x12 --spp 4 -q -o a.png --sampler independent --checkpoint a.film",
    );
    assert_eq!(run.status, Some(0), "{}", run.err);
    let before = folder.bytes("a.film");
    let same = "--resolution 16x12 --sampler independent";
    for (program, options, words) in [
        ("puremc", format!("cornell {same} --seed 1"), "its seed is 0, not 1"),
        (
            "puremc",
            "cornell --resolution 16x12 --sampler sobol".into(),
            "its sampler is independent, not sobol",
        ),
        (
            "puremc",
            "cornell --resolution 12x16 --sampler independent".into(),
            "its size is 16x12, not 12x16",
        ),
        (
            "puremc",
            format!("cornell {same} --max-depth 3"),
            "its method is puremc, not puremc --max-depth 3",
        ),
        ("particle", format!("cornell {same}"), "its method is puremc, not particle"),
        (
            "puremc",
            format!("cornell {same} --spp 3"),
            "it has 4 passes, pass 3 among them, and 3 are wanted",
        ),
        (
            "puremc",
            format!("cornell {same} --spp 8 --shard 1/2"),
            "it has pass 0, and part 1/2 has passes 4 to 7",
        ),
        ("puremc", format!("furnace {same}"), "(cornell), not "),
    ] {
        let output = if options.contains("--shard") { "" } else { "-o b.png" };
        let run =
            folder.run(program, &format!("{options} -q {output} --checkpoint a.film --resume"));
        assert_eq!((run.status, run.out.as_str()), (Some(6), ""), "{options}: {}", run.err);
        assert!(run.err.starts_with("error: a.film: is not of this rendering: it"), "{}", run.err);
        assert!(run.err.contains(words) && run.err.lines().count() == 1, "{}", run.err);
        assert!(folder.bytes("a.film") == before);
    }
    let path = folder.path().join("a.film");
    let (film, mut about) = load_film(&path).unwrap();
    about.settings[0].1 = "0.0.1".into();
    save_film(&path, None, &film, &about).unwrap();
    let run = folder.run("puremc", &format!("cornell {same} --checkpoint a.film --resume -q"));
    assert_eq!(run.status, Some(6));
    assert!(run.err.contains("its revision is 0.0.1, not "), "{}", run.err);
}

/// The content of a scene counts, not how it is written, nor where.
#[test]
fn a_scene_that_was_changed_is_another() {
    let folder = Folder::new();
    fs::create_dir(folder.path().join("b")).unwrap();
    let options = "-q --spp 2 --checkpoint a.film --resume -o a.png";
    let scene = SCENE.replace("0.5, 0.5, 0.5", "0.5, 0.4, 0.3");
    folder.write("my.ron", &scene);
    assert_eq!(folder.run("puremc", &format!("my.ron {options}")).status, Some(0));
    folder.write("b/my.ron", &format!("// Mine.\n{scene}"));
    assert_eq!(folder.run("puremc", &format!("b/my.ron {options}")).status, Some(0));
    for (old, new) in [("0.4", "0.41"), ("radius: 1", "radius: 1.0001"), ("fov: 40", "fov: 41")] {
        assert!(scene.contains(old));
        folder.write("my.ron", &scene.replace(old, new));
        let run = folder.run("puremc", &format!("my.ron {options}"));
        assert_eq!(run.status, Some(6), "{old}: {}", run.err);
        assert!(run.err.contains("its scene is "), "{}", run.err);
    }
}

#[test]
fn damaged_and_foreign_files_are_told_and_stay() {
    let folder = Folder::new();
    let options = "cornell --resolution 16x12 -q --checkpoint a.film --resume";
    for spp in [3, 5] {
        assert_eq!(folder.run("puremc", &format!("{options} --spp {spp}")).status, Some(0));
    }
    let whole = folder.bytes("a.film");
    let mut torn = whole.clone();
    torn[whole.len() - 100] ^= 1;
    let mut newer = whole.clone();
    newer[8] = 9;
    let kept = "; a.film.previous is whole, with 4 passes: rename it to go on from there\n";
    for (bytes, why) in [
        (torn, "it is damaged from pixel 0 on"),
        (whole[..whole.len() / 2].to_vec(), " bytes instead of "),
        (whole[..20].to_vec(), "its header is damaged"),
        (newer, "its format has version 9, and this program knows version 1"),
        (b"P6 1 1 255\n".to_vec(), "it is no film"),
        (Vec::new(), "it is no film"),
    ] {
        fs::write(folder.path().join("a.film"), &bytes).unwrap();
        let run = folder.run("puremc", &format!("{options} --spp 9"));
        assert_eq!((run.status, run.out.as_str()), (Some(3), ""), "{}", run.err);
        assert!(run.err.starts_with("error: a.film: cannot be read as a film: "), "{}", run.err);
        assert!(run.err.contains(why) && run.err.ends_with(kept), "{}", run.err);
        assert!(run.err.lines().count() == 1 && folder.bytes("a.film") == bytes, "{}", run.err);
    }
    // Killed between two names.
    fs::remove_file(folder.path().join("a.film")).unwrap();
    let run = folder.run("puremc", &format!("{options} --spp 5"));
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(folder.bytes("a.film") == whole);
}

/// Files of 512 bytes at most stand for a full disk; what goes on afterwards has lost nothing.
#[test]
fn a_full_disk_leaves_the_checkpoint_before() {
    let folder = Folder::new();
    let options = "cornell --resolution 64x48 -q --checkpoint a.film --resume";
    assert_eq!(folder.run("puremc", &format!("{options} --spp 2")).status, Some(0));
    let before = (folder.bytes("a.film"), folder.names());
    for options in ["--spp 4", "--spp 4 --checkpoint-every 0.001s", "--spp 2 -o b.png"] {
        let program = env!("CARGO_BIN_EXE_puremc");
        let size = "cornell --resolution 64x48 -q --checkpoint a.film --resume";
        let script = format!("ulimit -f 1; exec {program} {size} {options}");
        let mut shell = Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", &script]);
        let run = Run::from(shell.output().unwrap());
        assert_eq!((run.status, run.out.as_str()), (Some(4), ""), "{options}: {}", run.err);
        let file = if options.contains("b.png") { "b.png" } else { "a.film" };
        let said = format!("error: {file}: cannot be written: ");
        assert!(run.err.starts_with(&said) && run.err.lines().count() == 1, "{}", run.err);
        assert!((folder.bytes("a.film"), folder.names()) == before, "{options}");
    }
    let run = folder.run("puremc", &format!("{options} --spp 4 -o b.png"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    let expected = undisturbed("puremc", "cornell --resolution 64x48 -q --spp 4 -o b.png");
    assert!(["a.film", "b.png"].iter().all(|name| folder.bytes(name) == expected[*name]));
    let run = folder.run("puremc", "cornell --resolution 8x6 --checkpoint none/a.film -q");
    assert_eq!(run.status, Some(4));
    assert_eq!(run.err, "error: none/a.film: cannot be written: there is no such folder\n");
}

/// The folder goes away while it is rendered.
#[test]
fn a_folder_that_vanishes_is_an_error() {
    let folder = Folder::new();
    fs::create_dir(folder.path().join("b")).unwrap();
    let options = "cornell --resolution 16x12 -q --time-limit 1h --checkpoint b/a.film";
    let mut child = folder.command("puremc", &format!("{options} --checkpoint-every 0.01s"));
    let mut child = child.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    while !folder.path().join("b/a.film").exists() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
    fs::rename(folder.path().join("b"), folder.path().join("c")).unwrap();
    let run = Run::from(child.wait_with_output().unwrap());
    assert_eq!(run.status, Some(4), "{}", run.err);
    assert!(run.err.starts_with("error: b/a.film: cannot be written: "), "{}", run.err);
    load_film(&folder.path().join("c/a.film")).unwrap();
}
