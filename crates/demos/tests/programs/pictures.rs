//! The programs' pictures, and what they say about them.

use crate::common::{Folder, SCENE, programs};
use std::process::Command;
use traylib_io::load_exr;

const TINY: &str = "--resolution 32x24 --spp 2";

fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes.ends_with(b"IEND\xae\x42\x60\x82")
}

#[test]
fn every_program_writes_both_kinds_of_picture_and_their_names() {
    for program in programs() {
        let folder = Folder::new();
        let run = folder.run(program, &format!("{TINY} -o a.png cornell --outfile b.exr"));
        assert_eq!(run.status, Some(0), "{program}: {}", run.err);
        assert_eq!(run.out, "a.png\nb.exr\n", "{program}");
        assert_eq!(folder.names(), ["a.png", "b.exr"], "{program}");
        assert!(is_png(&std::fs::read(folder.path().join("a.png")).unwrap()), "{program}");
        let picture = load_exr(&folder.path().join("b.exr")).unwrap();
        assert_eq!((picture.width(), picture.height()), (32, 24), "{program}");
        let light: f32 = picture.values().iter().map(|pixel| pixel.r + pixel.g + pixel.b).sum();
        assert!(light > 0.0 && light.is_finite(), "{program}: {light}");
    }
}

#[test]
fn a_scene_of_ones_own_goes_to_a_picture_named_as_the_program() {
    let folder = Folder::new();
    folder.write("my.ron", SCENE);
    let run = folder.run("puremc", "--spp 1 my.ron");
    assert_eq!((run.status, run.out.as_str()), (Some(0), "puremc.png\n"), "{}", run.err);
    assert_eq!(folder.names(), ["my.ron", "puremc.png"]);
}

#[test]
fn threads_do_not_change_the_picture_and_seeds_do() {
    let folder = Folder::new();
    for program in programs() {
        let pixels = |options: &str| {
            let run = folder.run(program, &format!("{TINY} -q -o a.exr {options}"));
            assert_eq!(run.status, Some(0), "{program}: {}", run.err);
            let picture = load_exr(&folder.path().join("a.exr")).unwrap();
            let bits = |x: f32| x.to_bits();
            let values = picture.values().iter();
            values.map(|pixel| [pixel.r, pixel.g, pixel.b].map(bits)).collect::<Vec<_>>()
        };
        let one = pixels("--threads 1 --seed 7");
        assert!(one == pixels("--threads 2 --seed 7"), "{program}");
        assert!(one != pixels("--threads 2 --seed 8"), "{program}");
    }
}

#[test]
fn checking_renders_nothing() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "cornell --check -o a.png");
    assert_eq!(run.status, Some(0), "{}", run.err);
    let expected =
        "cornell: 15 primitives, 7 materials, 1 area lamp, 0 point lights, 400x300 pixels\n";
    assert_eq!(run.out, expected);
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn the_end_of_a_run_says_what_ended_it() {
    let folder = Folder::new();
    let spp = folder.run("directlight", TINY);
    assert!(spp.err.contains("directlight cornell: 2 spp in "), "{}", spp.err);
    assert!(spp.err.contains("; ended by --spp\n"), "{}", spp.err);
    let time = folder.run("directlight", "--resolution 32x24 --time-limit 0.2s");
    assert_eq!(time.status, Some(0), "{}", time.err);
    assert!(time.err.contains("; ended by --time-limit\n"), "{}", time.err);
    let both = folder.run("directlight", &format!("{TINY} --time-limit 1h"));
    assert!(both.err.contains("; ended by --spp\n"), "{}", both.err);
}

/// The description in a picture makes it again, bit for bit, whatever else was asked for, and no
/// folder's name is in it.
#[test]
fn a_picture_says_how_to_make_it_again() {
    let folder = Folder::new();
    folder.write("my room.ron", SCENE);
    let tiny = "--resolution 16x12 --seed 5 --exposure 0.3";
    for (program, options) in [
        ("trace", "--spp 3"),
        ("trace", ""),
        ("trace", "--spp 1 --time-limit 1h"),
        ("puremc", "--max-depth 4 --time-limit 0.1s --roulette off"),
        ("particle", "--spp 2 --roulette 2"),
        ("directlight", "--spp 2"),
        ("directlight", "--spp 2 --combine --heuristic balance"),
        ("bdpt", "--spp 2 --heuristic balance --direct-sum --max-depth 7"),
        ("bdpt", "--time-limit 0.1s --limit surfaces=3M"),
    ] {
        let room = folder.path().join("my room.ron");
        let mut command =
            folder.command(program, &format!("{options} {tiny} -q -o a.exr -o a.png"));
        assert!(command.arg(&room).output().unwrap().status.success());
        let told = folder.run("film", "info a.exr").out;
        let again = told.lines().find_map(|line| line.trim().strip_prefix("command = ")).unwrap();
        assert!(
            again.starts_with(&format!("{program} 'my room.ron' --resolution 16x12 ")),
            "{again}"
        );
        assert_eq!(again.contains(" --limit surfaces=3000000 "), options.contains("--limit s"));
        let words = again.strip_prefix(&format!("{program} 'my room.ron' ")).unwrap();
        let mut command = folder.command(program, &format!("{words} -q -o b.exr -o b.png"));
        let run = command.arg("my room.ron").output().unwrap();
        assert!(run.status.success(), "{again}: {run:?}");
        let bits = |name: &str| {
            let picture = load_exr(&folder.path().join(name)).unwrap();
            picture
                .values()
                .iter()
                .map(|light| light.to_array().map(f32::to_bits))
                .collect::<Vec<_>>()
        };
        assert_eq!(bits("a.exr"), bits("b.exr"), "{again}");
        let read = |name: &str| image_bytes(&std::fs::read(folder.path().join(name)).unwrap());
        assert_eq!(read("a.png"), read("b.png"), "{again}");
    }
}

/// The chunks that are the picture itself.
fn image_bytes(png: &[u8]) -> Vec<u8> {
    let start = png.windows(4).position(|name| name == b"IDAT").unwrap();
    png[start..].to_vec()
}

#[test]
fn programs_say_their_version_and_revision() {
    let folder = Folder::new();
    let git = Command::new("git").args(["rev-parse", "--short=12", "HEAD"]).output();
    let revision = git.ok().filter(|output| output.status.success());
    for program in programs().into_iter().chain(["film"]) {
        let said = folder.run(program, "--version").out;
        assert!(said.starts_with(&format!("{program} {}", env!("CARGO_PKG_VERSION"))), "{said}");
        if let Some(revision) = &revision {
            let revision = String::from_utf8_lossy(&revision.stdout);
            assert!(said.ends_with(&format!(" ({})\n", revision.trim())), "{said}");
        }
    }
    let run = folder.run("bdpt", "cornell --resolution 8x6 --spp 1 -q -o a.exr");
    assert_eq!(run.status, Some(0), "{}", run.err);
    let version = folder.run("bdpt", "--version").out.replace("bdpt", "TrayLib");
    let told = folder.run("film", "info a.exr").out;
    assert!(told.contains(&format!("    software = {version}")), "{told}");
}

#[test]
fn being_quiet_leaves_the_result_alone() {
    let folder = Folder::new();
    let run = folder.run("trace", &format!("-q {TINY}"));
    assert_eq!((run.out.as_str(), run.err.as_str()), ("trace.png\n", ""));
}

const CAUSTIC: &str = r#"(
    camera: (position: (0, 0, 3), target: (0, 0, 0), fov: 40, resolution: (8, 8)),
    materials: {
        "mirror": Mirror(reflectance: (1, 1, 1)),
        "grey": Lambert(reflectance: (0.5, 0.5, 0.5)),
    },
    objects: [
        (shape: Sphere(center: (0, 0, 0), radius: 1), material: "mirror"),
        (shape: Sphere(center: (0, 0, 0), radius: 9, facing: Inward), material: "grey"),
    ],
    lights: [Point(position: (0, 3, 0), intensity: (10, 10, 10))],
)
"#;

#[test]
fn programs_say_what_they_cannot_see() {
    let folder = Folder::new();
    folder.write("caustic.ron", CAUSTIC);
    let notes = |program: &str, scene: &str| {
        let run = folder.run(program, &format!("{scene} --check"));
        assert_eq!(run.status, Some(0), "{}", run.err);
        let notes = run.err.lines().filter(|line| line.starts_with("note: "));
        notes.map(str::to_owned).collect::<Vec<_>>()
    };
    let caustics = "light of point lamps that a mirror or glass throws onto other surfaces";
    let puremc = notes("puremc", "caustic.ron");
    assert!(puremc.contains(&format!("note: puremc cannot produce {caustics}")), "{puremc:?}");
    let trace = notes("trace", "cornell");
    let lamps = "note: trace cannot produce the light that area lamps throw on other surfaces";
    assert!(trace.iter().any(|note| note == lamps), "{trace:?}");
    assert_eq!(notes("bdpt", "cornell"), [""; 0]);
    let short = notes("bdpt", "cornell --max-depth 2");
    assert!(short[0].contains("of more than 2 edges"), "{short:?}");
}

#[test]
fn help_fits_a_terminal_and_ends_with_examples() {
    let folder = Folder::new();
    for program in programs() {
        let long = folder.run(program, "--help");
        let short = folder.run(program, "-h");
        assert_eq!((long.status, short.status), (Some(0), Some(0)));
        for line in long.out.lines().chain(short.out.lines()) {
            assert!(line.chars().count() <= 80, "{program}: {line}");
        }
        let (_, examples) = long.out.split_once("Examples:\n").unwrap();
        let (examples, words) = examples.split_once("\n\n").unwrap();
        for defined in ["The estimated error, `err`", "made, as a command", "143 if it was"] {
            assert!(words.contains(defined), "{program}: {words}");
        }
        assert_eq!(examples.lines().count(), 3, "{program}");
        assert!(examples.lines().all(|line| line.trim_start().starts_with(program)));
    }
}
