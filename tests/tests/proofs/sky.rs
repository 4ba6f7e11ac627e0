//! The sky against closed forms, which stand in `traylib_known::sky`, and the methods under it
//! against one another.

use traylib_geometry::Ray;
use traylib_integrators::{Method, Settings};
use traylib_io::{LoadOptions, load_scene_with};
use traylib_known::sky::{
    ball_under_sky, floor_under_picture, translucent_ball, whole_floor_under_picture, yard,
};
use traylib_known::stage::{glass, lambert, max_phong, mirror, pane, paper, phong};
use traylib_known::{Case, each_pass, settings_by_pass};
use traylib_math::{Sampler, Vec3};
use traylib_scene::{Light, Scene};
use traylib_tests::ablation::{Budget, open_ball, random_subset};
use traylib_tests::agreement::{self, Other, Subject, agree};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::chi_square::follows;
use traylib_tests::measure::all_hold;
use traylib_tests::methods::{BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// A light sample of a sky that is the same all around is wasted every second time, so that what
/// is weighed with them is noisier than walks alone.
const METHODS: [(Method, u32); 4] =
    [(PURE_MC, 32), (COMBINED, 300), (BDPT, 400), (BDPT_BALANCE, 320)];

/// Under a sky of 1 no material is to be seen that loses nothing.
#[test]
fn s1_nothing_is_to_be_seen() {
    for (seed, case) in (600..).zip([
        ball_under_sky("white", lambert(1.0), 1.0),
        ball_under_sky("grey", lambert(0.5), 0.5),
        ball_under_sky("mirror", mirror(0.7, 0.3), 1.0),
        ball_under_sky("paper", paper(0.5, 0.5), 1.0),
        ball_under_sky("glass", glass(1.5), 1.0),
    ]) {
        all_hold(&case, seed, &METHODS);
    }
    // Light that was mirrored to and fro within is worth more for it.
    let case = ball_under_sky("pane", pane(0.3, 0.7), 1.0);
    all_hold(&case, 610, &[(PURE_MC, 600), (BDPT, 800)]);
}

/// Lobes lose what dips below the horizon: nothing is brighter than the sky, and all methods
/// have it equally dark.
#[test]
fn s1_lobes_lose_the_same() {
    for (seed, material) in (620..).zip([phong(0.4, 0.6, 20.0), max_phong(1.0, 50.0)]) {
        let Case { scene, .. } = ball_under_sky("lobes", material, 1.0);
        let mean = |method: Method| {
            let (mut sum, passes) = (0.0, 64);
            each_pass(&scene, method.build().as_ref(), &settings_by_pass(passes, seed), |pass| {
                let pixels = pass.values();
                let all: f64 = pixels.iter().map(|pixel| pixel[1]).sum();
                sum += all / pixels.len() as f64 / f64::from(passes);
            });
            sum
        };
        let [walked, combined, both] = [PURE_MC, COMBINED, BDPT].map(mean);
        assert!(walked < 1.0 && walked > 0.7, "{walked}");
        // 65,536 samples of a relative deviation below 1/2: ten standard errors.
        for found in [combined, both] {
            assert!((found / walked - 1.0).abs() < 0.02, "{walked} {found}");
        }
    }
}

#[test]
fn s2_floor() {
    let methods = [(DIRECT_LIGHT, 160), (COMBINED, 160), (BDPT, 160), (BDPT_BALANCE, 160)];
    all_hold(&floor_under_picture(), 640, &methods);
}

#[test]
fn s2_whole_floor() {
    all_hold(&whole_floor_under_picture(), 641, &[(BDPT, 700), (PARTICLE, 1600)]);
}

#[test]
fn s3_translucent_ball() {
    for depth in [None, Some(3)] {
        all_hold(&translucent_ball(depth), 650, &[(COMBINED, 1200), (BDPT, 1000)]);
    }
}

/// Chance of a false alarm of a comparison; there are some 60.
const LEVEL: f64 = 1e-5;
const SETS: Budget = Budget { batches: 16, passes: 12, level: LEVEL, equivalence: 0.15 };
/// Some find little of the light, by long walks from it.
const ALONE: Budget = Budget { passes: 64, ..SETS };

#[test]
fn each_technique_alone_finds_all_light_of_the_sky() {
    settle(&open_ball().each_alone(ALONE, 660));
}

#[test]
fn any_techniques_share_the_light_of_the_sky() {
    let spectrum = open_ball();
    let share = |number: u64| {
        spectrum.subset(&random_subset(&spectrum, number), SETS, 1000 * (number + 670))
    };
    let findings: Vec<Finding> = (0..3).flat_map(share).collect();
    settle(&findings);
}

/// The built-in scene under a sky.
fn terrace() -> Scene {
    let options = LoadOptions { resolution: Some((48, 36)), ..LoadOptions::default() };
    load_scene_with("terrace", options).unwrap().scene
}

fn yard_agrees(looks: Vec<u32>, others: &[(Method, u32)], promise: f64) {
    let other = |&(method, passes): &(Method, u32)| Other { method, passes, promise };
    let others: Vec<Other> = others.iter().map(other).collect();
    let (scene, budget) = (yard(), agreement::Budget { tile: 12, looks });
    settle(&agree(&Subject { name: "yard", scene: &scene }, &others, &budget).findings);
}

#[test]
fn methods_agree_under_the_sky() {
    yard_agrees(vec![96], &[(COMBINED, 4), (PARTICLE, 1), (DIRECT_LIGHT, 4)], 0.05);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn methods_agree_under_the_sky_at_length() {
    let from_light = [(BDPT_BALANCE, 1), (PARTICLE, 24)];
    let walks = [(COMBINED, 4), (DIRECT_LIGHT, 4), (PURE_MC, 16)];
    yard_agrees(vec![256, 1024, 4096], &[&from_light[..], &walks].concat(), 5e-3);
}

/// Directions fall into cells of equal solid angle as often as their density says.
#[test]
fn directions_follow_their_density() {
    let scene = terrace();
    let Some(Light::Sky(sky)) = scene.lights().last() else { panic!("no sky") };
    let id = scene.light_ids().last().unwrap();
    let (columns, rows, fine) = (16, 10, 120);
    let mut expected = vec![0.0; columns * rows];
    let from = Vec3::ZERO;
    let density = |direction: Vec3| {
        let ray = Ray::new(from, direction);
        let (_, point) = scene.emitting_point(&scene.sky_behind(&ray).unwrap()).unwrap();
        f64::from(scene.light(id).toward_pdf(from, &point).0)
    };
    let (width, height) = (columns * fine, rows * fine);
    let solid_angle = 4.0 * std::f64::consts::PI / (width * height) as f64;
    for (x, y) in (0..width).flat_map(|x| (0..height).map(move |y| (x, y))) {
        let across = std::f32::consts::TAU * (x as f32 + 0.5) / width as f32;
        let up = 1.0 - 2.0 * (y as f32 + 0.5) / height as f32;
        let sine = (1.0 - up * up).sqrt();
        let direction = Vec3::new(sine * across.sin(), up, sine * across.cos());
        expected[y / fine * columns + x / fine] += density(direction) * solid_angle;
    }
    assert!((expected.iter().sum::<f64>() - 1.0).abs() < 0.02);
    // The sun's cells are known to a few in a hundred by the grid: all but it are asked.
    let mut sampler = Sampler::numbered(680, 0);
    let mut counts = vec![0; columns * rows];
    let n = 200_000;
    for _ in 0..n {
        let (point, pdf) = scene.sample_light(id, from, sampler.next_2d());
        let (direction, _) = point.seen_from(from).unwrap();
        assert!((f64::from(pdf.0) / density(direction) - 1.0).abs() < 1e-5);
        assert_eq!(sky.radiance(direction), point.emitted);
        let turn = direction.x.atan2(direction.z) / std::f32::consts::TAU;
        let x = ((turn - turn.floor()) * columns as f32) as usize;
        let y = (0.5 * (1.0 - direction.y) * rows as f32) as usize;
        counts[y.min(rows - 1) * columns + x.min(columns - 1)] += 1;
    }
    let is_plain = |cell: &usize| expected[*cell] < 0.05;
    let cells: Vec<usize> = (0..expected.len()).filter(is_plain).collect();
    assert!(cells.len() > 140, "{}", cells.len());
    let share = |cell: &usize| expected[*cell];
    let plain: f64 = cells.iter().map(share).sum();
    let found: Vec<u64> = cells.iter().map(|&cell| counts[cell]).collect();
    let wanted: Vec<f64> = cells.iter().map(|cell| share(cell) / plain).collect();
    settle(&[follows("directions of the sky", &wanted, &found)]);
}

/// The same bits on any number of threads, and for the same scene in units of half a metre.
#[test]
fn threads_do_not_change_a_bit_under_the_sky() {
    let scene = terrace();
    for method in [COMBINED, BDPT, PARTICLE] {
        let picture = |threads| {
            let settings = Settings { threads, ..settings_by_pass(4, 690) };
            let mut passes = Vec::new();
            each_pass(&scene, method.build().as_ref(), &settings, |pass| {
                passes.push(pass.values().to_vec());
            });
            passes
        };
        assert!(picture(1) == picture(3), "{method}");
    }
}
