//! The reports of `bdpt` beside a picture, some of which `directlight` has, too: techniques and
//! single pixels.

use crate::common::Folder;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use traylib_integrators::{Bdpt, Control, Method, Progress, Report, Settings, Technique, render};
use traylib_io::{LoadOptions, TextureLimits, load_scene_with, load_texture};
use traylib_math::{Grid, Rgb};

/// A point light in a mirror.
const F15: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/failure/f15-point-caustic.ron");

#[test]
fn weighted_techniques_add_up_to_the_picture() {
    let options = LoadOptions { resolution: Some((24, 18)), ..LoadOptions::default() };
    for scene in ["cornell", "pyramid"] {
        let scene = load_scene_with(scene, options).unwrap().scene;
        let bdpt = Bdpt { report: Report::Techniques, ..Bdpt::default() };
        let settings = Settings { spp: 3, seed: 1, threads: 1, ..Settings::default() };
        let rendering = render(&scene, &bdpt, &settings, &Control::default(), &mut |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let whole = rendering.film.develop();
        let layers = rendering.film.develop_layers();
        let weighted = layers.into_iter().filter(|&(layer, _)| Technique::of_layer(layer).weighted);
        let layers: Vec<_> = weighted.map(|(_, picture)| picture).collect();
        assert!(layers.len() > 5);
        for (index, whole) in whole.values().iter().enumerate() {
            let light = |layer: &Grid<Rgb>| layer.values()[index].g;
            let sum: f32 = layers.iter().map(light).sum();
            // A weight is rounded to f32 in a layer: an ulp a contribution.
            assert!((sum - whole.g).abs() <= 1e-4 * whole.g, "{index}: {sum} {}", whole.g);
        }
    }
}

#[test]
fn techniques_are_written_as_pictures() {
    let folder = Folder::new();
    let run = folder.run("bdpt", "--resolution 16x12 --spp 1 --techniques a/b -o whole.png");
    assert_eq!(run.status, Some(0), "{}", run.err);
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    let sheets = ["a/b/all-weighted.png", "a/b/all-raw.png"];
    assert!(sheets.iter().all(|sheet| run.out.lines().any(|file| file == *sheet)), "{}", run.out);
    let is_alone = |file: &&str| *file != "whole.png" && !sheets.contains(file);
    for file in run.out.lines().filter(is_alone) {
        let path = folder.path().join(file);
        assert!(path.is_file(), "{file}");
        let name = path.file_stem().unwrap().to_str().unwrap();
        let (technique, kind) = name.rsplit_once('-').unwrap();
        assert!(technique.starts_with('s') && technique.contains("-t"), "{file}");
        *kinds.entry(kind.to_owned()).or_default() += 1;
    }
    assert_eq!(kinds.keys().collect::<Vec<_>>(), ["raw", "weighted"]);
    assert!(kinds["raw"] > 3 && kinds["raw"] == kinds["weighted"], "{kinds:?}");
    let written = std::fs::read_dir(folder.path().join("a/b")).unwrap().count();
    assert_eq!(written, kinds["raw"] + kinds["weighted"] + sheets.len());
}

/// Each place of the sheet has the bytes of the picture that belongs there, by the layout that
/// is documented: four pixels around 16x12.
#[test]
fn sheets_show_each_technique_in_its_place() {
    let folder = Folder::new();
    let run =
        folder.run("bdpt", "--resolution 16x12 --spp 2 --max-depth 4 --techniques t -o a.png -q");
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    let bytes = |name: &str| {
        let path = folder.path().join("t").join(name);
        load_texture(&path, TextureLimits::default()).unwrap().pixels
    };
    for kind in ["weighted", "raw"] {
        let sheet = bytes(&format!("all-{kind}.png"));
        assert_eq!((sheet.width(), sheet.height()), (5 * 20 + 4, 4 * 16 + 4));
        let mut found = 0;
        for (edges, s) in (1..=4).flat_map(|edges| (0..=edges).map(move |s| (edges, s))) {
            let name = format!("s{s}-t{}-{kind}.png", edges + 1 - s);
            if folder.path().join("t").join(&name).exists() {
                let alone = bytes(&name);
                let (left, top) = (4 + 20 * s, 4 + 16 * (edges - 1));
                let is_there = |at: usize| {
                    let (x, y) = (at % 16, at / 16);
                    sheet.get(left + x, top + y) == alone.get(x, y)
                };
                assert!((0..16 * 12).all(is_there), "{name}");
                found += 1;
            }
        }
        assert!(found > 8, "{found}");
    }
}

/// The number that follows a word.
fn number_after(line: &str, word: &str) -> Option<f64> {
    line.split_once(word)?.1.split_whitespace().next()?.parse().ok()
}

#[test]
fn the_weights_of_every_path_of_a_pixel_sum_to_one() {
    let folder = Folder::new();
    let mirrored = format!("{F15} --pixel 16,12");
    for options in ["cornell --pixel 5,9", "plates --pixel 16,12 --heuristic balance", &mirrored] {
        let run = folder.run("bdpt", &format!("{options} --resolution 32x24 --spp 4"));
        assert_eq!(run.status, Some(0), "{}", run.err);
        let paths: Vec<&str> = run.out.split("\n\n").filter(|path| !path.is_empty()).collect();
        assert!(paths.len() >= 4, "{options}: {}", paths.len());
        for path in paths {
            let (head, vertices) = path.split_once('\n').unwrap();
            let s: usize = head.split(['=', ',']).nth(1).unwrap().parse().unwrap();
            let weights: Vec<f64> = vertices
                .lines()
                .enumerate()
                .map(|(i, line)| number_after(line, &format!("weight of s={i} ")).unwrap())
                .collect();
            let sum: f64 = weights.iter().sum();
            // Six digits each.
            assert!((sum - 1.0).abs() <= 1e-6 * weights.len() as f64, "{path}");
            let own = number_after(head, "weight ").unwrap();
            assert!((own - weights[s]).abs() <= 2e-6, "{path}");
        }
    }
    assert_eq!(folder.names(), [""; 0], "no picture was asked for");
}

/// The paths that `directlight` tells of a pixel are what the pixel is made of, and telling them
/// changes no picture.
#[test]
fn the_paths_of_a_pixel_add_up_to_it() {
    let options = LoadOptions { resolution: Some((32, 24)), ..LoadOptions::default() };
    for (scene, method) in
        [("cornell", Method::COMBINED), ("plates", Method::DIRECT_LIGHT), (F15, Method::COMBINED)]
    {
        let scene = load_scene_with(scene, options).unwrap().scene;
        let settings = Settings { spp: 4, seed: 1, threads: 1, ..Settings::default() };
        let [told, plain] = [Report::Pixel(15 * 32 + 20), Report::None].map(|report| {
            let integrator = method.build_with(report);
            let observe = &mut |_: &Progress<'_>| ControlFlow::Continue(());
            render(&scene, integrator.as_ref(), &settings, &Control::default(), observe).unwrap()
        });
        assert_eq!(told.film.develop().values(), plain.film.develop().values());
        let number = |note: &str, word| number_after(note, word).unwrap();
        let parts = told.notes.iter().map(|note| number(note, "value ") * number(note, "weight "));
        let (sum, whole) = (parts.sum::<f64>() / 4.0, plain.film.develop().values()[15 * 32 + 20]);
        assert!(sum > 0.0 && (sum / f64::from(whole.r) - 1.0).abs() < 1e-4, "{method}: {sum}");
    }
}
