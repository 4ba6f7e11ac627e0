use super::*;
use crate::bdpt::room;
use crate::{Bdpt, Chunk, Control, Settings, render_to_end};
use traylib_scene::{Film, Scene};

#[test]
fn paths_from_both_ends_and_tests_never_meet() {
    let first = |mut sampler: Sampler| VertexNumbers::next(&mut sampler);
    let camera = first(Purpose::Camera.sampler(1, 0, 3));
    let light = first(Purpose::Light.sampler(1, 0, 3));
    let test = first(Sampler::numbered(1, 3));
    assert_eq!(camera, first(Purpose::Camera.sampler(1, 0, 3)));
    assert!(camera != light && light != test && test != camera);
}

const ALL: Dimensions = Dimensions { light_point: true, light_pick: true, lobe: true };
const PATHS: u32 = 1024;

/// A pass over 32 × 32 pixels with as many light paths.
fn pass(control: &Control, seed: u64, pass: u64) -> Chunk<'_> {
    Chunk {
        seed,
        pass,
        pixels: 0..PATHS,
        light_paths: 0..PATHS,
        light_path_count: PATHS,
        points: PointSet::Sobol,
        dimensions: ALL,
        control,
    }
}

/// A pixel and the light path that it is always joined with: each meets the points of its
/// own sequence, and both together all of the square. Sixteen cells of a thousand passes;
/// of independent numbers one in a thousand million would leave a cell less than half full.
#[test]
fn every_pixel_sees_all_light_paths() {
    let control = Control::default();
    for path in [0, 1, 517, PATHS - 1] {
        let (mut starts, mut pairs) = ([0; 16], [0; 16]);
        for number in 0..1024 {
            let pass = pass(&control, 4, number);
            let start = pass.light_sampler(path).vertex().light_point;
            let pixel = pass.camera_sampler(path).pixel_point();
            let cell = |x: f32, y: f32| 4 * (4.0 * x) as usize + (4.0 * y) as usize;
            starts[cell(start.x, start.y)] += 1;
            pairs[cell(start.x, pixel.x)] += 1;
        }
        for cells in [starts, pairs] {
            assert!(cells.iter().all(|count| (32..=96).contains(count)), "{path}: {cells:?}");
        }
    }
}

/// One pass gives each point of the light paths' run to one of them.
#[test]
fn light_paths_of_a_pass_are_stratified() {
    let control = Control::default();
    for number in [0, 3, 4, 1001] {
        let pass = pass(&control, 2, number);
        let mut seen = vec![false; PATHS as usize];
        for path in 0..PATHS {
            let at = pass.light_sampler(path).vertex().light_point;
            seen[(at.x * PATHS as f32) as usize] = true;
        }
        assert!(seen.iter().all(|seen| *seen), "{number}");
    }
}

/// The mean of a smooth function of the numbers of a path, over so many passes.
fn mean(seed: u64, passes: u64, points: PointSet) -> f64 {
    let control = Control::default();
    let of_pass = |number| {
        let mut sampler = Chunk { points, ..pass(&control, seed, number) }.camera_sampler(7);
        let (pixel, first, second) = (sampler.pixel_point(), sampler.vertex(), sampler.vertex());
        let squares = [pixel, first.light_point, second.light_point];
        let bumps = squares.map(|at| f64::from(at.x * (1.0 - at.x) + at.y));
        let lobes = [first.bsdf, second.bsdf].map(|u| f64::from(u[0] + u[1] * u[2]));
        let picks = 1.0 + 0.5 * (first.light_pick + second.light_pick);
        bumps.iter().chain(&lobes).sum::<f64>() * picks
    };
    (0..passes).map(of_pass).sum::<f64>() / passes as f64
}

/// Means are the same, and that of quasi-random points has a hundredth of the variance and
/// less: each of the sixteen numbers has to be the right one, and in the right order of bits.
#[test]
fn quasi_random_points_are_even() {
    const SEEDS: u64 = 64;
    let spread = |points| {
        let means: Vec<f64> = (0..SEEDS).map(|seed| mean(seed, 1024, points)).collect();
        let mean = means.iter().sum::<f64>() / SEEDS as f64;
        let squares = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>();
        (mean, squares / (SEEDS - 1) as f64)
    };
    let [(independent, plain), (sobol, even)] = PointSet::ALL.map(spread);
    // Five standard errors of the independent mean.
    assert!((independent - sobol).abs() < 5.0 * (plain / SEEDS as f64).sqrt());
    assert!(even < 0.01 * plain, "{even:e} {plain:e}");
}

/// A pixel's numbers and a light path's have each a shift of their own: the same for both would
/// leave the two in step from seed to seed.
#[test]
fn both_ends_and_all_pixels_are_shifted_apart() {
    let control = Control::default();
    let bits = |number: f32| (number * (1 << 24) as f32) as u32;
    let mut together = [std::collections::BTreeSet::new(), std::collections::BTreeSet::new()];
    for seed in 0..32 {
        let pass = pass(&control, seed, 0);
        let pixel = |pixel| bits(pass.camera_sampler(pixel).pixel_point().x);
        // Light path 0 has the point that rotation gives it: its own first bits say which.
        let turned = (PATHS - rotation(seed, 0, PATHS) as u32) % PATHS;
        let light = bits(pass.light_sampler(turned).vertex().light_point.x);
        together[0].insert(pixel(0) ^ light);
        together[1].insert(pixel(0) ^ pixel(1));
    }
    assert!(together.iter().all(|differences| differences.len() == 32), "{together:?}");
}

/// The error that a film states is that of renderings by other seeds: sixteen of them, a thousand
/// pixels each. The ratio has a standard deviation of a twentieth.
#[test]
fn the_stated_error_is_that_of_other_seeds() {
    const SEEDS: u64 = 16;
    let scene: Scene = room();
    let films = (0..SEEDS).map(|seed| {
        let settings = Settings { spp: 32, seed, points: PointSet::Sobol, ..Settings::default() };
        render_to_end(&scene, &Bdpt::default(), &settings).unwrap().film
    });
    let films: Vec<_> = films.collect();
    let means: Vec<_> = films.iter().map(Film::mean).collect();
    let pixels = means[0].values().len();
    let (mut stated, mut found) = (0.0, 0.0);
    for pixel in 0..pixels {
        let values = means.iter().map(|mean| mean.values()[pixel][1]);
        let mean = values.clone().sum::<f64>() / SEEDS as f64;
        found += values.map(|value| (value - mean).powi(2)).sum::<f64>() / (SEEDS - 1) as f64;
        let of_film = films.iter().map(|film| film.variance_of_mean().unwrap().values()[pixel][1]);
        stated += of_film.sum::<f64>() / SEEDS as f64;
    }
    let ratio = (stated / found).sqrt();
    assert!((0.8..1.25).contains(&ratio), "{ratio}");
}

#[test]
fn points_have_names() {
    for points in PointSet::ALL {
        assert_eq!(points.name().parse(), Ok(points));
    }
    assert!("random".parse::<PointSet>().is_err());
}
