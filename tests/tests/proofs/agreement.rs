//! The programs against one another on the paper's scenes.
//!
//! Welch's test on tiles, the number of passes fixed beforehand, the family's
//! level split by Holm over all tiles of all pairs. Light that only rare chance
//! finds has no usable variance: a floor lit by way of a mirror and seen in one,
//! a small lamp in `puremc`. Where a few passes make up the variance of a tile it
//! is left out and counted; in the short form, whose passes may not even have met
//! such light, the pairs are chosen so that there is none.

use traylib_integrators::Settings;
use traylib_io::{LoadOptions, load_scene_with};
use traylib_math::Vec2;
use traylib_scene::Scene;
use traylib_tests::measure::each_pass;
use traylib_tests::programs::Program;
use traylib_tests::statistics::{Sample, batch_means, holm, tile_means, welch};

const FAMILY_LEVEL: f64 = 1e-3;
const BATCHES: usize = 32;
/// The largest part of a tile's variance that one pass may make up. Of n normal
/// values the largest makes up about 2·ln n/n.
const CHANCE: f64 = 0.15;

/// How much to render.
#[derive(Clone, Copy)]
struct Budget {
    width: u32,
    height: u32,
    tile: usize,
    /// For bdpt; the others get as many times more as their samples are cheaper.
    passes: u32,
}

/// A scene, and a program to compare with bdpt there.
struct Pair {
    scene: &'static str,
    other: Program,
    max_depth: Option<u32>,
}

/// Tiles of one rendering: a value a pass.
struct Tiles(Vec<Vec<f64>>);

fn render(scene: &Scene, program: Program, pair: &Pair, budget: Budget) -> Tiles {
    let passes = match program {
        Program::PureMc => 8 * budget.passes,
        Program::Combined => 4 * budget.passes,
        _ => budget.passes,
    };
    let settings = Settings { spp: passes, seed: 1 + program as u64, threads: 0 };
    let mut tiles: Vec<Vec<f64>> = Vec::new();
    let integrator = program.integrator(pair.max_depth);
    let statistics = each_pass(scene, integrator.as_ref(), &settings, |pass| {
        let luminance = pass.map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b);
        let means = tile_means(&luminance, budget.tile);
        tiles.resize(means.len(), Vec::new());
        for (tile, mean) in tiles.iter_mut().zip(means) {
            tile.push(mean);
        }
    });
    assert_eq!(statistics.rejected, 0, "{}, {program:?}", pair.scene);
    Tiles(tiles)
}

impl Tiles {
    fn is_steady(&self, tile: usize) -> bool {
        let values = &self.0[tile];
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares = values.iter().map(|value| (value - mean).powi(2));
        let sum: f64 = squares.clone().sum();
        sum > 0.0 && squares.fold(0.0, f64::max) <= CHANCE * sum
    }

    fn sample(&self, tile: usize) -> Sample {
        Sample::of(&batch_means(&self.0[tile], BATCHES))
    }

    /// Mean over the tiles that `keep` names, a value a pass.
    fn image(&self, keep: &[usize]) -> Sample {
        let passes = self.0[0].len();
        let mean =
            |pass| keep.iter().map(|&tile| self.0[tile][pass]).sum::<f64>() / keep.len() as f64;
        Sample::of(&batch_means(&(0..passes).map(mean).collect::<Vec<_>>(), BATCHES))
    }
}

/// Tiles in which nothing is seen in an ideal mirror.
fn tiles_without_mirrors(scene: &Scene, budget: Budget) -> Vec<bool> {
    let columns = (budget.width as usize).div_ceil(budget.tile);
    let mut free = vec![true; columns * (budget.height as usize).div_ceil(budget.tile)];
    for y in 0..budget.height {
        for x in 0..budget.width {
            let ray = scene.camera().ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
            if scene.intersect(&ray).is_some_and(|point| point.model.has_delta_part()) {
                free[y as usize / budget.tile * columns + x as usize / budget.tile] = false;
            }
        }
    }
    free
}

/// Compares bdpt with other programs; `equivalence` is asked of image means whose
/// interval is narrow enough, and the interval is printed in any case.
fn all_agree(pairs: &[Pair], budget: Budget, equivalence: f64) {
    let (mut p_values, mut names) = (Vec::new(), Vec::new());
    for pair in pairs {
        let Pair { scene: name, other: program, .. } = *pair;
        let options = LoadOptions { resolution: Some((budget.width, budget.height)) };
        let scene = load_scene_with(name, options).unwrap().scene;
        let bdpt = render(&scene, Program::BdptPower, pair, budget);
        let other = render(&scene, program, pair, budget);
        let visible = tiles_without_mirrors(&scene, budget);
        let keep: Vec<usize> = (0..visible.len())
            .filter(|&tile| visible[tile] || program != Program::Particle)
            .filter(|&tile| bdpt.is_steady(tile) && other.is_steady(tile))
            .collect();
        assert!(2 * keep.len() >= visible.len(), "{name}, {program:?}: {} steady", keep.len());
        for &tile in &keep {
            p_values.push(welch(&bdpt.sample(tile), &other.sample(tile)));
            names.push(format!("{name}, {program:?}, tile {tile}"));
        }
        let (a, b) = (bdpt.image(&keep), other.image(&keep));
        p_values.push(welch(&a, &b));
        names.push(format!("{name}, {program:?}, all tiles"));
        let ratio = b.mean / a.mean;
        // Half width of a 99.9 % interval, Student's with 31 degrees of freedom.
        let half = 3.63 * (a.variance_of_mean + b.variance_of_mean).sqrt() / a.mean;
        println!(
            "{name}: {program:?} / bdpt = {ratio:.5} ± {half:.5} over {} of {} tiles",
            keep.len(),
            visible.len(),
        );
        if half < 0.5 * equivalence {
            assert!((ratio - 1.0).abs() < equivalence, "{name}, {program:?}: {ratio} ± {half}");
        }
    }
    let smallest = p_values.iter().copied().fold(1.0, f64::min);
    println!("{} tests, smallest p {smallest:.1e}", p_values.len());
    let refused = holm(&p_values, FAMILY_LEVEL);
    let found: Vec<_> = (0..names.len()).filter(|&i| refused[i]).map(|i| &names[i]).collect();
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn programs_agree() {
    let pairs = [
        Pair { scene: "cornell", other: Program::Combined, max_depth: None },
        Pair { scene: "cornell", other: Program::PureMc, max_depth: None },
        Pair { scene: "small-light", other: Program::Combined, max_depth: Some(2) },
        Pair { scene: "pyramid", other: Program::Particle, max_depth: None },
        Pair { scene: "plates", other: Program::Combined, max_depth: None },
    ];
    all_agree(&pairs, Budget { width: 48, height: 36, tile: 12, passes: 96 }, 5e-3);
}

/// The same at length, on all the paper's scenes without a limit. Prints its
/// budget and the intervals reached.
#[test]
#[ignore = "many minutes; run in release"]
fn programs_agree_closely() {
    let budget = Budget { width: 48, height: 36, tile: 12, passes: 4096 };
    let Budget { width, height, tile, passes } = budget;
    println!(
        "{width} x {height} pixels, tiles of {tile} x {tile}; {passes} passes of bdpt and \
         particle, 4 times as many of directlight --combine, 8 times of puremc"
    );
    let scenes = ["cornell", "small-light", "pyramid", "plates"];
    let others = [Program::Combined, Program::PureMc];
    let pairs: Vec<Pair> = scenes
        .into_iter()
        .flat_map(|scene| others.map(|other| Pair { scene, other, max_depth: None }))
        .chain([Pair { scene: "pyramid", other: Program::Particle, max_depth: None }])
        .collect();
    all_agree(&pairs, budget, 5e-3);
}
