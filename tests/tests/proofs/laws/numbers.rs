//! Laws of random numbers, of choosing from lists, and of the maps from the unit
//! square.

use super::{FAST, LONG, sampler};
use glam::DVec3;
use std::f64::consts::TAU;
use traylib_geometry::{Vec2, Vec3};
use traylib_integrators::toolkit::VertexNumbers;
use traylib_known::frame::frame;
use traylib_known::grid::{At, Counts, even};
use traylib_known::stage::{Stage, black, camera, disk_facing_down};
use traylib_math::{DiscreteDistribution, Sampler, warp};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::chi_square::follows;

/// A map is right if the point of the square in which its density is even comes
/// back evenly.
fn warp_finding(name: &str, samples: u64, place: impl Fn(Vec2) -> At) -> Finding {
    let mut sampler = sampler(name);
    let mut counts = Counts::new(0);
    for _ in 0..samples {
        counts.add(place(sampler.next_2d()));
    }
    follows(format!("warp to {name}"), &even(), &counts.cells)
}

fn turn(x: f64, y: f64) -> f64 {
    y.atan2(x).rem_euclid(TAU) / TAU
}

/// 1 − cosα to an axis, and the azimuth around it.
fn around(axis: Vec3, w: Vec3) -> At {
    let [axis, u, v] = frame(DVec3::from(axis));
    let w = DVec3::from(w).normalize();
    [0.5 * (w - axis).length().powi(2), turn(u.dot(w), v.dot(w))]
}

fn warp_laws(samples: u64) {
    let axis = Vec3::new(0.48, -0.6, -0.64);
    let mut findings = vec![
        // sin²θ = (1 − cosθ)(1 + cosθ).
        warp_finding("a cosine hemisphere", samples, |u| {
            let [one_minus_cos, phi] = around(axis, warp::cosine_hemisphere(axis, u));
            [one_minus_cos * (2.0 - one_minus_cos), phi]
        }),
        warp_finding("a sphere", samples, |u| {
            let [one_minus_cos, phi] = around(axis, warp::uniform_sphere(u));
            [0.5 * one_minus_cos, phi]
        }),
        warp_finding("a disk", samples, |u| {
            let [x, y] = warp::uniform_disk(u).to_array().map(f64::from);
            [x * x + y * y, turn(x, y)]
        }),
        // The share of the triangle nearer to the first corner is (b + c)².
        warp_finding("a triangle", samples, |u| {
            let [b, c] = warp::uniform_triangle(u).to_array().map(f64::from);
            [(b + c).powi(2), if b + c > 0.0 { c / (b + c) } else { 0.0 }]
        }),
    ];
    findings.extend([1.5, 1e-2, 1e-6].map(|width| {
        warp_finding(&format!("a cone, 1 − cos = {width}"), samples, |u| {
            let [one_minus_cos, phi] = around(axis, warp::uniform_cone(axis, width, u));
            [one_minus_cos / f64::from(width), phi]
        })
    }));
    findings.extend([0.0, 1.0, 50.0, 1e6].map(|n| {
        warp_finding(&format!("a lobe of exponent {n}"), samples, |u| {
            let [one_minus_cos, phi] = around(axis, warp::cosine_power_lobe(axis, n, u));
            [((f64::from(n) + 1.0) * f64::ln_1p(-one_minus_cos.min(1.0))).exp(), phi]
        })
    }));
    settle(&findings);
}

#[test]
fn warps_follow_their_densities() {
    warp_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn warps_follow_their_densities_at_length() {
    warp_laws(LONG);
}

/// All eight numbers of a vertex, by name.
fn eight(numbers: &VertexNumbers) -> [f64; 8] {
    let VertexNumbers { pass_through, bsdf: [lobe, x, y], roulette, light_pick, light_point } =
        *numbers;
    let [pass_through, lobe, x, y, roulette] = [pass_through, lobe, x, y, roulette].map(f64::from);
    [pass_through, lobe, x, y, roulette, light_pick, light_point.x.into(), light_point.y.into()]
}

/// Every pair of the numbers of one vertex, and each number with the same of the
/// next vertex and of the next path, fills the square evenly.
fn stream_laws(samples: u64) {
    const PAIRS: usize = 28;
    let mut within = vec![Counts::new(0); PAIRS];
    let mut onward = vec![Counts::new(0); 16];
    for path in 0..samples {
        let vertices = |path| {
            let mut sampler = Sampler::new(8, [Sampler::TESTS, 1, path]);
            // The camera's film point comes first.
            sampler.next_2d();
            [(); 2].map(|()| eight(&VertexNumbers::next(&mut sampler)))
        };
        let [first, second] = vertices(2 * path);
        let [neighbour, _] = vertices(2 * path + 1);
        let pairs = (0..8).flat_map(|i| (0..i).map(move |j| (i, j)));
        for ((i, j), counts) in pairs.zip(&mut within) {
            counts.add([first[i], first[j]]);
        }
        for (i, counts) in onward.iter_mut().enumerate() {
            let other = if i < 8 { second } else { neighbour };
            counts.add([first[i % 8], other[i % 8]]);
        }
    }
    let finding = |(i, counts): (usize, Counts)| {
        follows(format!("numbers of a vertex, pair {i}"), &even(), &counts.cells)
    };
    settle(&within.into_iter().chain(onward).enumerate().map(finding).collect::<Vec<_>>());
}

#[test]
fn numbers_of_vertices_are_even_and_unrelated() {
    stream_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn numbers_of_vertices_are_even_and_unrelated_at_length() {
    stream_laws(LONG);
}

/// Indices come as often as their weights say, from few and from many, and a
/// scene's lamps as often as their power, or a sixteenth of its mean.
fn choice_laws(samples: u64) {
    let few = vec![1.0, 0.0, 2.5, 1e-3, 7.0];
    let many: Vec<f32> = (0..1000_u16).map(|i| 1.0 + f32::from(i % 17)).collect();
    let mut findings: Vec<Finding> = [few, many]
        .iter()
        .map(|weights| {
            let distribution = DiscreteDistribution::new(weights).unwrap();
            let name = format!("choice among {}", weights.len());
            choice_finding(&name, weights, samples, |u| distribution.choose(u).0)
        })
        .collect();
    let radiances: Vec<f32> = (0..40_u8).map(|i| 0.5 + f32::from(i)).collect();
    let stage = Stage::new(camera(Vec3::ZERO, Vec3::Z, 40.0, 8));
    let scene = radiances.iter().enumerate().fold(stage, |stage, (i, &radiance)| {
        stage.light(disk_facing_down(Vec3::Z * (i + 1) as f32, 1.0), radiance, black())
    });
    let scene = scene.build();
    let mean = radiances.iter().sum::<f32>() / radiances.len() as f32;
    let weights: Vec<f32> = radiances.iter().map(|radiance| radiance.max(mean / 16.0)).collect();
    assert!(weights[0] > radiances[0], "one of them is raised");
    findings.push(choice_finding("choice of a lamp", &weights, samples, |u| {
        let id = scene.choose_light(u).id;
        scene.light_ids().position(|other| other == id).unwrap()
    }));
    settle(&findings);
}

fn choice_finding(
    name: &str,
    weights: &[f32],
    samples: u64,
    choose: impl Fn(f64) -> usize,
) -> Finding {
    let total: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
    let cells: Vec<f64> = weights.iter().map(|&weight| f64::from(weight) / total).collect();
    let mut counts = vec![0; weights.len()];
    let mut sampler = sampler(name);
    for _ in 0..samples {
        counts[choose(sampler.next_fine())] += 1;
    }
    follows(name, &cells, &counts)
}

#[test]
fn choices_follow_their_weights() {
    choice_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn choices_follow_their_weights_at_length() {
    choice_laws(LONG);
}
