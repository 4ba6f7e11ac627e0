//! `film`: what it says of pictures, and how it refuses.

use crate::common::{Folder, Run};
use serde_json::Value;
use traylib_io::{PictureInfo, Tone, save_picture};
use traylib_math::{Grid, Rgb};

fn save(folder: &Folder, name: &str, picture: &Grid<Rgb>) {
    let info = PictureInfo {
        exposure: 1.0,
        tone: Tone::Linear,
        program: "tests 1.0".into(),
        integrator: "bdpt".into(),
        command: "bdpt ball.ron".into(),
        scene: "a\nball".into(),
        seed: 7,
        spp: 16,
        rejected_samples: 0,
        frame: None,
    };
    save_picture(&folder.path().join(name), picture, &info).unwrap();
}

/// 16 × 8 pixels of radiance one, but for some.
fn picture(others: &[(usize, [f32; 3])]) -> Grid<Rgb> {
    let mut picture = Grid::filled(16, 8, Rgb::WHITE);
    for &(index, [r, g, b]) in others {
        picture.values_mut()[index] = Rgb::new(r, g, b);
    }
    picture
}

/// A folder with two pictures: in `a.exr` the pixel 5,1 is as the tests say.
fn folder(pixel: [f32; 3]) -> Folder {
    let folder = Folder::new();
    save(&folder, "a.exr", &picture(&[(21, pixel)]));
    save(&folder, "b.exr", &picture(&[]));
    folder
}

#[track_caller]
fn json(run: &Run) -> Value {
    serde_json::from_str(&run.out).unwrap()
}

#[track_caller]
fn close(found: &Value, expected: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0), "{found} {expected}");
}

#[test]
fn differences_are_measured() {
    let run = folder([4.0, 1.0, 1.0]).run("film", "diff a.exr b.exr --json");
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    let found = json(&run);
    // One of 384 values is off by 3; the floor is 0.01.
    close(&found["epsilon"], 0.01);
    close(&found["mse"], 9.0 / 384.0);
    close(&found["rel_mse"], 9.0 / 1.01 / 384.0);
    close(&found["trimmed_rel_mse"], 9.0 / 1.01 / 384.0);
    close(&found["smape"], 3.0 / 5.0 / 384.0);
    close(&found["bias"], 3.0 / 384.0);
    // Blocks that differ by 3 and 0: mean 1.5, standard error 1.5.
    close(&found["bias_z"], 1.0);
    assert_eq!(found["blocks"], 2);
    assert_eq!(found["worst"]["at"], serde_json::json!([5, 1]));
    close(&found["worst"]["error"], 3.0 / 1.01);
    assert_eq!(found["left_out"]["first"], Value::Null);
}

#[test]
fn people_read_the_same_figures() {
    let run = folder([4.0, 1.0, 1.0]).run("film", "diff a.exr b.exr --epsilon 0");
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    for words in [
        "a.exr against b.exr, 16x8 pixels\n",
        "relMSE   2.3438e-2  with epsilon 0.0000e0\n",
        "bias     +0.7812 %",
        "z        1.00",
        "worst    3.0000e0  at 5,1: 4.0000 1.0000 1.0000 where 1.0000 1.0000 1.0000 is right\n",
    ] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    let same = folder([1.0; 3]).run("film", "diff a.exr b.exr --max-relmse 0");
    assert_eq!(same.status, Some(0), "{}", same.err);
    assert!(same.out.contains("worst    no pixel differs"), "{}", same.out);
}

#[test]
fn too_much_difference_is_a_status() {
    let folder = folder([4.0, 1.0, 1.0]);
    let allowed = folder.run("film", "diff a.exr b.exr --max-relmse 0.03");
    assert_eq!((allowed.status, allowed.err.as_str()), (Some(0), ""));
    let refused = folder.run("film", "diff a.exr b.exr --max-relmse 0.02");
    assert_eq!(refused.status, Some(7));
    assert_eq!(refused.out, folder.run("film", "diff a.exr b.exr").out);
    let said = "error: relMSE 2.3205e-2 is more than the 2e-2 of --max-relmse\n";
    assert_eq!(refused.err, said);
}

#[test]
fn pixels_that_are_not_finite_are_left_out_and_never_allowed() {
    let folder = folder([f32::NAN, 1.0, 1.0]);
    let run = folder.run("film", "diff a.exr b.exr");
    assert_eq!(run.status, Some(0), "{}", run.err);
    let said = "not finite, 1 of the picture and 0 of the reference, first 5,1\n";
    assert!(run.out.contains("relMSE   0.0000e0") && run.out.ends_with(said), "{}", run.out);
    let refused = folder.run("film", "diff a.exr b.exr --json --max-relmse 1");
    assert_eq!(refused.status, Some(7));
    assert_eq!(json(&refused)["left_out"]["picture"], 1);
    assert!(refused.err.contains("with --max-relmse none may be"), "{}", refused.err);
}

#[test]
fn a_file_says_what_is_in_it() {
    let folder = folder([-3.0, f32::INFINITY, 1.0]);
    let run = folder.run("film", "info a.exr b.exr");
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    for words in [
        "a.exr: 16x8 pixels\n  layer: 16x8 pixels at 0,0\n",
        "    G float: mean 1.0000e0, min 1.0000e0, max 1.0000e0; 1 not finite, 0 negative\n",
        "    R float: mean 9.6875e-1, min -3.0000e0, max 1.0000e0; 0 not finite, 1 negative\n",
        "    integrator = bdpt\n",
        "    scene = a ball\n",
        "    seed = 7\n    software = tests 1.0\n    spp = 16\n",
        "b.exr: 16x8 pixels\n",
    ] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    let found = json(&folder.run("film", "info --json a.exr"));
    let layer = &found[0]["layers"][0];
    assert_eq!(layer["attributes"]["rejectedSamples"], "0");
    assert_eq!(layer["channels"][1]["name"], "G");
    assert_eq!(layer["channels"][1]["not_finite"], 1);
    close(&layer["channels"][2]["mean"], 124.0 / 128.0);
}

/// Every format that is written, and so read, is compared and described.
#[test]
fn pictures_of_any_format_are_looked_at() {
    let folder = folder([0.0, 1.0, 1.0]);
    for format in ["exr", "hdr", "png", "tga", "pcx"] {
        let [a, b] = ["a", "b"].map(|name| format!("{name}.{format}"));
        if format != "exr" {
            for name in ["a", "b"] {
                let run = folder.run("film", &format!("convert {name}.exr {name}.{format}"));
                assert_eq!(run.status, Some(0), "{}", run.err);
            }
        }
        let run = folder.run("film", &format!("diff {a} {b} --json"));
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{format}");
        // One of 384 values is off by 1.
        close(&json(&run)["mse"], 1.0 / 384.0);
        let run = folder.run("film", &format!("info {a}"));
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{format}");
        let kind = if format == "exr" { "float" } else { "light" };
        let words =
            format!("    R {kind}: mean 9.9219e-1, min 0.0000e0, max 1.0000e0; 0 not finite");
        assert!(run.out.contains(&words), "{format}: {}", run.out);
        let says = ["exr", "png"].contains(&format);
        assert_eq!(run.out.contains("    command = bdpt ball.ron\n"), says, "{}", run.out);
    }
    folder.write("text.png", "no picture");
    for arguments in ["info text.png", "diff a.exr text.png"] {
        let said = fails(&folder, arguments, 3);
        assert!(said.starts_with("error: text.png: cannot be read as a picture: "), "{said}");
        assert_eq!(said.lines().count(), 1);
    }
}

/// Runs what must fail, and returns the one line it says.
#[track_caller]
fn fails(folder: &Folder, arguments: &str, status: i32) -> String {
    let run = folder.run("film", arguments);
    assert_eq!((run.status, run.out.as_str()), (Some(status), ""), "{arguments}: {}", run.err);
    run.err
}

#[test]
fn pictures_that_cannot_be_read_are_an_error_of_one_line() {
    let folder = folder([1.0; 3]);
    let whole = std::fs::read(folder.path().join("a.exr")).unwrap();
    std::fs::write(folder.path().join("cut.exr"), &whole[..whole.len() - 9]).unwrap();
    folder.write("text.exr", "no picture");
    folder.write("empty.exr", "");
    for name in ["cut", "text", "empty", "missing"] {
        let arguments = [format!("info {name}.exr"), format!("diff a.exr {name}.exr")];
        for arguments in arguments {
            let said = fails(&folder, &arguments, 3);
            let first = format!("error: {name}.exr: cannot be read as a picture: ");
            assert!(said.starts_with(&first) && said.lines().count() == 1, "{said}");
        }
    }
}

#[test]
fn pictures_of_two_sizes_are_an_error() {
    let folder = folder([1.0; 3]);
    save(&folder, "c.exr", &Grid::filled(8, 8, Rgb::WHITE));
    let said = fails(&folder, "diff a.exr c.exr", 3);
    let expected =
        "error: a.exr has 16x8 pixels and c.exr 8x8: only pictures of one size can be compared\n";
    assert_eq!(said, expected);
    save(&folder, "nan.exr", &Grid::filled(16, 8, Rgb::new(f32::NAN, 0.0, 0.0)));
    assert!(fails(&folder, "diff a.exr nan.exr", 3).contains("no pixel that is finite in both"));
}

#[test]
fn command_lines_that_make_no_sense() {
    let folder = folder([1.0; 3]);
    for (arguments, words) in [
        ("diff a.exr", "<B>"),
        ("info", "<FILE>..."),
        ("diff a.exr b.exr --max-relmse=-1", "wanted a number from 0 on"),
        ("diff a.exr b.exr --max-relmse nan", "wanted a number from 0 on"),
        ("diff a.exr b.exr --epsilon inf", "wanted a number from 0 on"),
        ("dif a.exr b.exr", "'diff'"),
    ] {
        let said = fails(&folder, arguments, 2);
        assert!(said.contains(words), "{arguments}: {said}");
    }
}

#[test]
fn help_fits_a_terminal_and_names_the_statuses() {
    let folder = Folder::new();
    for arguments in ["--help", "-h", "diff --help", "diff -h", "info --help", "convert --help"] {
        let run = folder.run("film", arguments);
        assert_eq!(run.status, Some(0), "{arguments}");
        assert!(run.out.lines().all(|line| line.chars().count() <= 80), "{}", run.out);
    }
    let long = folder.run("film", "--help").out;
    assert!(long.contains("Examples:\n  film info") && long.contains("7 if pictures"), "{long}");
}

/// Less noise than the film has, and a picture that says what was done to it.
#[test]
fn a_film_is_denoised() {
    let folder = Folder::new();
    let run = |words: &str| {
        let run = folder.run("bdpt", &format!("cornell --resolution 64x48 -q {words}"));
        assert_eq!(run.status, Some(0), "{}", run.err);
    };
    run("--spp 16 --checkpoint a.film -o a.exr");
    run("--spp 300 --seed 1 -o truth.exr");
    let denoised = folder.run("film", "denoise a.film b.exr");
    assert_eq!((denoised.status, denoised.out.as_str()), (Some(0), "b.exr\n"), "{}", denoised.err);
    assert!(denoised.err.contains("biased"));
    let error = |name: &str| {
        let diff = folder.run("film", &format!("diff {name} truth.exr --json")).out;
        let diff: Value = serde_json::from_str(&diff).unwrap();
        diff["rel_mse"].as_f64().unwrap()
    };
    let (before, after) = (error("a.exr"), error("b.exr"));
    assert!(after < 0.7 * before, "{before} {after}");
    assert!(folder.run("film", "info b.exr").out.contains("integrator = bdpt, denoised: biased"));
}

#[test]
fn noise_is_told_by_two_halves() {
    let folder = Folder::new();
    for (words, name) in [("--spp 1", "one"), ("--spp 4 --sampler independent", "even")] {
        let film = format!("cornell --resolution 8x6 -q {words} --checkpoint {name}.film");
        assert_eq!(folder.run("bdpt", &film).status, Some(0));
        let run = folder.run("film", &format!("denoise {name}.film out.png"));
        assert_eq!(run.status, Some(3));
        assert!(run.err.contains("two passes of `--sampler sobol`"), "{}", run.err);
    }
    assert!(!folder.names().contains(&"out.png".to_string()));
}
