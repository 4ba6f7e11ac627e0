//! Light that a mirror throws onto the floor, against closed forms; the scenes
//! and their truths stand in `traylib_known::mirrored`. Comparisons of whole
//! pictures belong to one family with those of `analytic.rs`; the 64 blocks of a
//! picture are a family of their own.

use std::time::Instant;
use traylib_integrators::{BlindSpot, Method, MethodSetting, SceneFacts, Statistics};
use traylib_known::mirrored::{
    NARROW_MIRROR, Picture, WIDE_MIRROR, mirrored_in, mirrored_light, mirrored_light_in_a_mirror,
    mirrored_light_in_a_mirror_with_a_hole, mirrored_point, mirrored_point_in_a_mirror, periscope,
    periscope_in_a_mirror, point_below_ball, point_below_faded_mirror, point_in_bare_periscope,
    point_in_periscope,
};
use traylib_known::stage::phong;
use traylib_known::{Case, each_pass, pass_means, samples_in_a_pass, settings_by_pass};
use traylib_statistics::{Sample, mean_interval, sidak, tile_means};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::measure::{EQUIVALENCE, FAMILY_LEVEL, Measured, judge};
use traylib_tests::methods::{self, BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// Side of a block in pixels.
const BLOCK: usize = 8;

/// Passes of a picture: the mean of each block and of the whole.
struct Passes {
    blocks: Vec<Vec<f64>>,
    image: Measured,
}

fn render(picture: &Picture, method: Method, passes: u32, seed: u64) -> Passes {
    let integrator = method.up_to(picture.max_depth).build();
    let settings = settings_by_pass(passes, seed);
    let (mut blocks, mut means) = (vec![Vec::new(); blocks(picture).len()], Vec::new());
    let statistics = each_pass(&picture.scene, integrator.as_ref(), &settings, |pass| {
        let pass = pass.map(|bands| bands[1]);
        let tiles = tile_means(pass.values(), pass.width(), BLOCK);
        means.push(tiles.iter().sum::<f64>() / tiles.len() as f64);
        blocks.iter_mut().zip(tiles).for_each(|(block, mean)| block.push(mean));
    });
    let samples = u64::from(passes) * samples_in_a_pass(&picture.scene);
    Passes { blocks, image: Measured { means, statistics, samples } }
}

/// Returns the true means of the blocks.
fn blocks(picture: &Picture) -> Vec<f64> {
    tile_means(picture.truth.values(), picture.truth.width(), BLOCK)
}

fn mean_of(values: &[f64]) -> f64 {
    Sample::of(values).mean
}

/// The mean of the picture, and every block within its interval.
fn compare(
    picture: &Picture,
    method: Method,
    passes: u32,
    seed: u64,
    equivalence: f64,
) -> [Finding; 2] {
    let rendered = render(picture, method, passes, seed);
    let claim = format!("{}, {method}: mean radiance", picture.name);
    let truth = blocks(picture);
    let image = judge(claim, &rendered.image, mean_of(&truth), equivalence);
    [image, all_blocks(picture, method, &rendered, &truth)]
}

/// Finds how far the worst block is from the truth, in half widths of its interval.
fn all_blocks(picture: &Picture, method: Method, rendered: &Passes, truth: &[f64]) -> Finding {
    let level = sidak(FAMILY_LEVEL, truth.len());
    let off = rendered.blocks.iter().zip(truth).map(|(means, truth)| {
        let interval = mean_interval(means, level);
        (interval.mean - truth).abs() / interval.half_width
    });
    let worst = off.fold(0.0, f64::max);
    Finding {
        claim: format!("{}, {method}: {} blocks", picture.name, truth.len()),
        statistic: format!("at most {worst:.2} half widths off"),
        level: Some(FAMILY_LEVEL),
        samples: rendered.image.samples,
        holds: worst <= 1.0,
    }
}

#[test]
fn c1_mirrored_lamp() {
    settle(&compare(&mirrored_light(WIDE_MIRROR), BDPT, 192, 201, 0.015));
}

#[test]
fn c1_half_shadows() {
    settle(&compare(&mirrored_light(NARROW_MIRROR), BDPT, 150, 202, 0.02));
}

/// To 0.2 %.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn c1_by_all_that_walk_from_the_lamp() {
    let picture = mirrored_light(WIDE_MIRROR);
    let narrow = mirrored_light(NARROW_MIRROR);
    let findings = [
        compare(&picture, BDPT, 7600, 203, 2e-3),
        compare(&picture, BDPT_BALANCE, 1500, 204, EQUIVALENCE),
        compare(&picture, PARTICLE, 1500, 205, EQUIVALENCE),
        compare(&narrow, BDPT, 2600, 206, EQUIVALENCE),
    ];
    settle(&findings.concat());
}

/// Seconds for an error of 1 % of the picture's mean: variance and time of a
/// pass.
fn seconds_to_a_percent(picture: &Picture, method: Method, passes: u32) -> f64 {
    let start = Instant::now();
    let rendered = render(picture, method, passes, 207);
    let seconds = start.elapsed().as_secs_f64();
    let Sample { variance_of_mean, .. } = Sample::of(&rendered.image.means);
    // A variance of the mean v after `seconds` falls as one over the time.
    seconds * variance_of_mean / (0.01 * mean_of(&blocks(picture))).powi(2)
}

/// Walks from both ends pay here, unless images of lamps are aimed at: with them `directlight` is
/// as quick.
/// `directlight` is as quick here. The times are this machine's; the factors are 10 and more.
#[test]
#[ignore = "at length: cargo xtask prove"]
fn c1_is_faster_from_both_ends() {
    let picture = mirrored_light(WIDE_MIRROR);
    let bdpt = seconds_to_a_percent(&picture, BDPT, 400);
    let without_images = |method: Method| method.and(MethodSetting::NoImages).unwrap();
    let others = [PURE_MC, without_images(DIRECT_LIGHT), without_images(COMBINED)];
    let findings = others.map(|method| {
        let factor = seconds_to_a_percent(&picture, method, 800) / bdpt;
        let claim = format!("C1: bdpt reaches 1 % sooner than {method}");
        println!("{claim}: {factor:.1} times");
        let statistic = format!("{factor:.1} times");
        let samples = 800 * samples_in_a_pass(&picture.scene);
        Finding { claim, statistic, level: None, samples, holds: factor > 2.0 }
    });
    settle(&findings);
}

/// Only hitting the lamp by chance finds this light, once in a thousand times:
/// right, and not much more can be said.
fn c2(methods: &[(Method, u32)], seed: u64, equivalence: f64) -> Vec<Finding> {
    let case = mirrored_light_in_a_mirror();
    let compare = |&(method, passes): &(Method, u32)| {
        let measured = measure(&case, method, passes, seed);
        let claim = format!("C2, {method}: mean radiance within {equivalence}");
        judge(claim, &measured, case.truth, equivalence)
    };
    methods.iter().map(compare).collect()
}

fn measure(case: &Case, method: Method, passes: u32, seed: u64) -> Measured {
    let integrator = method.up_to(case.max_depth).build();
    let settings = settings_by_pass(passes, seed);
    let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
    let samples = u64::from(passes) * samples_in_a_pass(&case.scene);
    Measured { means, statistics, samples }
}

#[test]
fn c2_seen_in_a_mirror() {
    let mut findings = c2(&[(PURE_MC, 160), (BDPT, 160)], 211, 0.25);
    findings.push(dark(&mirrored_light_in_a_mirror(), PARTICLE));
    settle(&findings);
}

/// Walks that aim at the image come to the mirror or through a hole in it.
#[test]
fn c2_with_a_hole() {
    let case = mirrored_light_in_a_mirror_with_a_hole();
    settle(&from_point(&case, &[(BDPT, 100), (COMBINED, 100)], 214, 0.03));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn c2_by_all_methods() {
    settle(&c2(&methods::from_camera(1200), 212, 0.09));
}

/// A method that finds no light at all, and says beforehand that there is light
/// that it cannot find.
fn dark(case: &Case, method: Method) -> Finding {
    let integrator = method.up_to(case.max_depth).build();
    let blind: Vec<BlindSpot> = integrator.blind_spots(&SceneFacts::of(&case.scene));
    let Measured { means, statistics: Statistics { rejected, .. }, samples } =
        measure(case, method, 4, 213);
    let found = means.iter().copied().fold(0.0, f64::max);
    Finding {
        claim: format!("{}, {method}: nothing of {:.3e}, announced", case.name, case.truth),
        statistic: format!("{found}; {blind:?}"),
        level: None,
        samples,
        holds: case.truth > 0.0 && found == 0.0 && rejected == 0 && !blind.is_empty(),
    }
}

/// Mean radiance by these methods, with so many passes each.
fn from_point(case: &Case, methods: &[(Method, u32)], seed: u64, equivalence: f64) -> Vec<Finding> {
    let compare = |&(method, passes): &(Method, u32)| {
        let claim = format!("{}, {method}: mean radiance", case.name);
        judge(claim, &measure(case, method, passes, seed), case.truth, equivalence)
    };
    methods.iter().map(compare).collect()
}

/// The methods that join points by way of mirrors, and passes enough.
const JOINING: [(Method, u32); 4] =
    [(DIRECT_LIGHT, 100), (COMBINED, 100), (BDPT, 100), (BDPT_BALANCE, 100)];

fn c3(methods: &[(Method, u32)], seed: u64, equivalence: f64) -> Vec<Finding> {
    from_point(&mirrored_point(), methods, seed, equivalence)
}

/// Light paths that are seen by the camera find it, and connections by way of the mirror, without
/// any chance but that of the place in the pixel.
#[test]
fn c3_point_light() {
    let mut findings = c3(&[(PARTICLE, 500)], 221, 0.03);
    findings.extend(c3(&JOINING, 221, EQUIVALENCE));
    findings.push(dark(&mirrored_point(), PURE_MC));
    settle(&findings);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn c3_point_light_at_length() {
    settle(&c3(&[(PARTICLE, 11_000)], 222, EQUIVALENCE));
}

/// A ball in the mirror's place: connections against light paths, which know nothing of their
/// Jacobian.
#[test]
fn a_ball_throws_what_light_paths_bring() {
    let scene = point_below_ball();
    let case = Case { name: "C3 by a ball".into(), scene, max_depth: Some(3), truth: 0.0 };
    // Known to 10⁻³ by the places in the pixels.
    let joined = measure(&case, DIRECT_LIGHT, 200, 224);
    let truth = mean_of(&joined.means);
    let case = Case { truth, ..case };
    let mut findings = from_point(&case, &[(PARTICLE, 2000)], 225, 0.03);
    findings.extend(from_point(&case, &[(BDPT, 200), (BDPT_BALANCE, 200)], 225, EQUIVALENCE));
    settle(&findings);
}

/// A mirror with a texture that says how much of it is there: connections see it where they cross
/// it, light paths where they meet it.
#[test]
fn c3_by_a_faded_mirror() {
    let case = point_below_faded_mirror();
    // Light paths pass through it by chance: twice the passes of a whole mirror.
    let joining = JOINING.map(|(method, passes)| (method, 2 * passes));
    let mut findings = from_point(&case, &joining, 226, EQUIVALENCE);
    findings.extend(from_point(&case, &[(PARTICLE, 1000)], 226, 0.03));
    settle(&findings);
}

/// Connections by way of the mirror alone.
#[test]
fn c2_and_c3_together() {
    let case = mirrored_point_in_a_mirror();
    let mut findings = from_point(&case, &JOINING, 223, EQUIVALENCE);
    findings.extend([PURE_MC, PARTICLE].map(|method| dark(&case, method)));
    settle(&findings);
}

/// The image of an image: walks from the camera aim at it. By chance they would find a lamp of this
/// size once in 200,000 times, so that the passes here would see it three times.
#[test]
fn c6_through_a_periscope() {
    let aiming = [(COMBINED, 60), (DIRECT_LIGHT, 60), (BDPT, 60)];
    let mut findings = from_point(&periscope_in_a_mirror(), &aiming, 241, 0.03);
    // Light paths see the floor's point as seldom as the camera's pixels are small.
    findings.extend(from_point(&periscope(), &aiming[..2], 242, 0.03));
    settle(&findings);
}

/// A point by way of two mirrors: joined for certain, but for the place in the pixel.
#[test]
fn c6_by_a_point() {
    let case = point_in_periscope();
    let mut findings = from_point(&case, &[(DIRECT_LIGHT, 8), (BDPT, 8)], 243, 2e-3);
    findings.push(dark(&case, PARTICLE));
    let bare = point_in_bare_periscope();
    findings.extend(from_point(&bare, &[(DIRECT_LIGHT, 8), (BDPT, 8)], 244, 2e-3));
    settle(&findings);
}

/// A sharp lobe in the mirror's place: not ks of the light, but ks times the
/// cosine, on average 0.95 here.
fn c4(exponent: f32, method: Method, passes: u32, equivalence: f64) -> Finding {
    let specular = 0.9;
    let picture = mirrored_in(phong(0.0, specular, exponent), f64::from(specular));
    let rendered = render(&picture, method, passes, 231);
    let claim = format!("C4 n = {exponent:e}, {method}: mean radiance");
    judge(claim, &rendered.image, mean_of(&blocks(&picture)), equivalence)
}

#[test]
fn c4_sharp_lobe() {
    settle(&[c4(1e6, PARTICLE, 300, 0.015)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn c4_sharp_lobes_at_length() {
    let one = |exponent| [BDPT, PARTICLE].map(|method| c4(exponent, method, 1300, EQUIVALENCE));
    settle(&[1e3, 1e6].map(one).concat());
}
