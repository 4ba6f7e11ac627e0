//! 3DS and MGF files given to programs as scenes.

use crate::common::Folder;
use std::ops::ControlFlow;
use traylib_integrators::{Control, PureMc, Settings, render};
use traylib_io::{LoadOptions, TextureLimits, load_scene_with, load_texture};

/// A closed room whose walls, seen from inside alone, reflect half and emit ¼.
const FURNACE: &str = "m wall =\n sides 1\n rd .5\n ed 140.58628\n\
    v a =\n p 0 0 0\nv b =\n p 2 0 0\nv c =\n p 2 3 0\nv d =\n p 0 3 0\nprism a b c d 4\n";

#[test]
fn in_a_furnace_radiance_is_what_it_must_be() {
    let folder = Folder::new();
    // Inward: the prism goes on along the normal of the face given first.
    folder.write("furnace.mgf", &FURNACE.replace("d 4", "d -4"));
    let options = LoadOptions { resolution: Some((24, 18)), ..LoadOptions::default() };
    let file = folder.path().join("furnace.mgf");
    let scene = load_scene_with(&file.to_string_lossy(), options).unwrap().scene;
    let settings = Settings { spp: 16, seed: 1, threads: 1, ..Settings::default() };
    let rendering = render(&scene, &PureMc::default(), &settings, &Control::default(), &mut |_| {
        ControlFlow::Continue(())
    });
    let film = rendering.unwrap().film.develop();
    let values: Vec<f64> = film.values().iter().map(|pixel| f64::from(pixel.g)).collect();
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let off = (mean - 0.5).abs() / (variance / count).sqrt();
    // Pixels are independent, 432 of them. One seed in 16,000 is further off.
    assert!(off < 4.0, "{mean}, {off} standard errors off ½");
    assert!(variance > 0.0);
}

/// However a scene is named, the MGF file beside it is found.
#[test]
fn a_scene_is_found_by_any_name() {
    let folder = Folder::new();
    folder.write("room.mgf", FURNACE);
    let camera = "camera: (position: (1, 1, 1), target: (1, 2, 2), fov: 40, resolution: (8, 6))";
    folder.write("scene.ron", &format!("({camera}, objects: [(shape: Mesh(file: \"room.mgf\"))])"));
    folder.write("outer.ron", &format!("({camera}, include: [\"scene.ron\"])"));
    let absolute = folder.path().join("scene.ron").display().to_string();
    let up = format!("../{}/scene.ron", folder.path().file_name().unwrap().display());
    for name in ["scene.ron", "./scene.ron", "outer.ron", "room.mgf", &absolute, &up] {
        for more in ["", "--stats -", "--root ."] {
            let run = folder.run("bdpt", &format!("{name} --check {more}"));
            assert_eq!(run.status, Some(0), "{name} {more}: {}", run.err);
        }
    }
}

/// A light at the camera shows a surface in its colour: of a half, met from 30° above, a
/// quarter comes back. Something small that glows does not change that.
#[test]
fn a_plate_without_a_lamp_is_seen_in_its_colour() {
    let folder = Folder::new();
    let plate = "m grey =\n sides 2\n rd 0.5\nv a =\n p 0 0 0\nv b =\n p 1 0 0\n\
                 v c =\n p 1 1 0\nv d =\n p 0 1 0\nf a b c d\n";
    folder.write("plate.mgf", plate);
    let eye = "m eye =\n ed 100\nv e =\n p 0 0 0\nv f =\n p 0 .01 0\n\
               v g =\n p .01 0 0\nf e f g\n";
    folder.write("eyed.mgf", &format!("{plate}{eye}"));
    for file in ["plate.mgf", "eyed.mgf"] {
        let run = folder.run("trace", &format!("{file} --resolution 81x61 -o o.png"));
        assert_eq!(run.status, Some(0), "{}", run.err);
        let picture = folder.path().join("o.png");
        let picture = load_texture(&picture, TextureLimits::default()).unwrap().pixels;
        let middle = picture.values()[81 * 30 + 40].g;
        // One of 256 steps is 0.004 here.
        assert!((middle - 0.25).abs() < 0.01, "{file}: {middle}");
    }
}

#[test]
fn a_limit_that_a_message_names_can_be_raised() {
    let folder = Folder::new();
    folder.write("room.mgf", FURNACE);
    let camera = "camera: (position: (1, 1, 1), target: (1, 2, 2), fov: 40, resolution: (8, 6))";
    folder.write("scene.ron", &format!("({camera}, objects: [(shape: Mesh(file: \"room.mgf\"))])"));
    for file in ["room.mgf", "scene.ron"] {
        for more in ["", "--stats -"] {
            let few = format!("{file} --check --limit memory=1k {more}");
            let refused = folder.run("bdpt", &few);
            // Of a scene file the figures are those of the scene itself.
            assert_eq!(refused.status, Some(3), "{few}: {}", refused.err);
            let remedy = "of memory; if that is meant, `--limit memory=2000` allows more";
            assert!(refused.err.contains(remedy), "{}", refused.err);
            let enough = folder.run("bdpt", &format!("{file} --check --limit memory=1M {more}"));
            assert_eq!(enough.status, Some(0), "{}", enough.err);
        }
    }
}

#[test]
fn only_trace_does_without_a_lamp() {
    let folder = Folder::new();
    folder.write("ball.mgf", "v c =\n\tp 0 0 1\nm grey =\n\trd .5\nsph c .5\n");
    let refused = folder.run("bdpt", "ball.mgf --resolution 8x6 --spp 1");
    assert_eq!(refused.status, Some(3), "{}", refused.err);
    assert!(refused.err.contains("nothing in it emits light"), "{}", refused.err);
    let checked = folder.run("trace", "ball.mgf --check");
    assert_eq!(checked.status, Some(0), "{}", checked.err);
    assert!(checked.err.contains("lit by a point light at the camera"), "{}", checked.err);
    let traced = folder.run("trace", "ball.mgf --resolution 8x6 --exposure 2");
    assert_eq!(traced.status, Some(0), "{}", traced.err);
    assert!(traced.err.contains("camera: (position: ("), "{}", traced.err);
    assert_eq!(folder.names(), ["ball.mgf", "trace.png"]);
}
