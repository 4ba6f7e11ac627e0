//! Geometry that hurts; the scenes and what is known of them stand in
//! `traylib_tests::{exchange, hard}`. Comparisons with known radiances belong to
//! one family with those of `analytic.rs`.

use glam::DVec3;
use traylib_geometry::{Primitive, Ray, Sides, Triangle, Vec3};
use traylib_integrators::{DirectLight, Integrator};
use traylib_known::analytic::phong_disk;
use traylib_known::exchange::corner;
use traylib_known::hard::{
    bumpy_plate, close_light, cube_of_slivers, grazing_light, grazing_view, lit_cube, tiny_light,
};
use traylib_known::polygonal::standing;
use traylib_known::{each_pass, pass_means, samples_in_a_pass, settings_by_pass};
use traylib_math::{Heuristic, Sampler, warp};
use traylib_statistics::{Sample, sidak, welch};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::measure::{FAMILY_LEVEL, all_hold};
use traylib_tests::methods::{self, BDPT, BDPT_BALANCE, COMBINED, DIRECT_LIGHT, PARTICLE, PURE_MC};

/// Every sample of the corner by itself.
fn corner_samples(integrator: &dyn Integrator, passes: u32, mut observe: impl FnMut(f64)) -> u64 {
    let scene = corner().scene;
    let settings = settings_by_pass(passes, 302);
    let statistics = each_pass(&scene, integrator, &settings, |pass| {
        pass.values().iter().for_each(|bands| observe(bands[1]));
    });
    assert_eq!(statistics.rejected, 0);
    u64::from(passes) * samples_in_a_pass(&scene)
}

/// A light sample by solid angle is worth ρ·Le/π·cosθ·Ω, no more than ρ·Le = 1.5 beside a
/// wall; by area it would be ρ·Le/π·A·G, without bound and variance next to the edge.
/// Weighted by the balance heuristic, both ways to find the lamp together give no more.
fn corner_bounds(passes: u32) -> [Finding; 2] {
    let combine = Some(Heuristic::Balance);
    let ways = [("light", None), ("combined", combine)];
    ways.map(|(name, combine)| {
        let method = DirectLight { combine, ..DirectLight::default() };
        let mut greatest = 0.0_f64;
        let samples = corner_samples(&method, passes, |value| greatest = greatest.max(value));
        Finding {
            claim: format!("D1: {name} samples in a corner are at most ρ·Le = 1.5"),
            statistic: format!("{greatest:.6}"),
            level: None,
            samples,
            holds: greatest > 1.4 && greatest <= 1.5 * (1.0 + 1e-5),
        }
    })
}

#[test]
fn d1_corner() {
    settle(&corner_bounds(300));
    all_hold(&corner(), 303, &[(DIRECT_LIGHT, 1000), (BDPT_BALANCE, 1000)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn d1_corner_by_all_methods() {
    settle(&corner_bounds(2000));
    let methods =
        [(PURE_MC, 4500), (DIRECT_LIGHT, 4500), (COMBINED, 1500), (BDPT, 1200), (PARTICLE, 4800)];
    all_hold(&corner(), 304, &methods);
}

#[test]
fn d2_lamp_at_a_wall() {
    all_hold(&standing(1.0, 1.0, 0.01), 311, &[(COMBINED, 720)]);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn d2_lamp_at_a_wall_by_all_methods() {
    let methods = [(PURE_MC, 1200), (BDPT, 800), (BDPT_BALANCE, 800)];
    all_hold(&standing(1.0, 1.0, 0.01), 310, &methods);
}

#[test]
fn d3_lamp_close_above_the_floor() {
    let methods = [(PURE_MC, 32), (COMBINED, 32), (BDPT, 32)];
    all_hold(&close_light(DVec3::Z, 1e-6), 312, &methods);
    all_hold(&close_light(DVec3::new(0.3, -0.5, 0.8), 2e-5), 312, &methods);
}

#[test]
fn d4_and_d5_grazing() {
    all_hold(&grazing_view(), 313, &[(COMBINED, 80), (BDPT, 80)]);
    all_hold(&grazing_light(), 314, &methods::from_camera(32));
    all_hold(&standing(0.01, 1.0, 1.0), 315, &[(DIRECT_LIGHT, 144)]);
}

#[test]
fn d8_and_d9_tiny_lamps() {
    all_hold(&tiny_light(), 318, &[(DIRECT_LIGHT, 32), (COMBINED, 32), (BDPT, 32)]);
    all_hold(&phong_disk(1e6, 1e-3), 319, &[(COMBINED, 80), (BDPT, 80)]);
}

/// D7: no closed form; methods agree, each pair by Welch's test.
fn bumpy(passes: u32) -> Vec<Finding> {
    let scene = bumpy_plate();
    let methods = [COMBINED, BDPT, PARTICLE];
    let samples: Vec<Sample> = (0..)
        .zip(methods)
        .map(|(i, method)| {
            let settings = settings_by_pass(passes, 320 + i);
            let integrator = method.build();
            let (means, statistics) = pass_means(&scene, integrator.as_ref(), &settings);
            assert_eq!(statistics.rejected, 0, "{method}");
            Sample::of(&means)
        })
        .collect();
    let level = sidak(FAMILY_LEVEL, 3);
    [(0, 1), (0, 2), (1, 2)]
        .map(|(a, b)| {
            let p = welch(&samples[a], &samples[b]);
            let [of_a, of_b] = [a, b].map(|i| samples[i].mean);
            let error = samples[a].variance_of_mean.sqrt().max(samples[b].variance_of_mean.sqrt());
            Finding {
                claim: format!("D7 slopes of 5: {} and {} agree", methods[a], methods[b]),
                statistic: format!("{of_a:.5} and {of_b:.5} to {error:.5}, p = {p:.1e}"),
                level: Some(level),
                samples: 2 * u64::from(passes) * samples_in_a_pass(&scene),
                holds: p > level && error < 0.01 * of_a,
            }
        })
        .into()
}

#[test]
fn d7_steep_normals() {
    settle(&bumpy(200));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn d7_steep_normals_at_length() {
    settle(&bumpy(3000));
}

/// Four scales that are no powers of two.
const SCALES: [f32; 4] = [1e-4, 1e-2, 1e3, 1e6];

#[test]
fn d6_and_d10_rooms() {
    all_hold(&cube_of_slivers(), 331, &[(BDPT, 128)]);
    for scale in SCALES {
        let case = lit_cube(format!("D10 × {scale:e}"), Vec3::ZERO, scale);
        all_hold(&case, 332, &[(BDPT, 128)]);
    }
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn d6_and_d10_by_other_methods() {
    let methods = [(COMBINED, 300), (BDPT_BALANCE, 300), (PARTICLE, 2500)];
    all_hold(&cube_of_slivers(), 333, &methods);
    for scale in SCALES {
        let case = lit_cube(format!("D10 × {scale:e}"), Vec3::ZERO, scale);
        all_hold(&case, 334, &methods);
    }
}

/// 10⁴ times as far from the origin as it is large.
const FAR: Vec3 = Vec3::new(2e4, -2e4, 1e4);

/// A coordinate is off by half a unit in the last place of 2·10⁴, some 10⁻³, and
/// a ray starts at most 6·2⁻²⁴ of that coordinate off its wall, 0.7 % of the half
/// side. Where it starts so much higher the room seems so much smaller, on both
/// sides; light is out by no more than the square of that.
#[test]
fn d11_far_from_the_origin() {
    let case = lit_cube("D11".into(), FAR, 1.0);
    let findings = [PURE_MC, BDPT].map(|method| {
        let settings = settings_by_pass(160, 341);
        let integrator = method.build();
        let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &settings);
        let ratio = Sample::of(&means).mean / case.truth;
        let bound = 4.0 * 6.0 * 2e4 * 2.0_f64.powi(-24);
        Finding {
            claim: format!("D11, {method}: the radiance is right to {bound:.3}"),
            statistic: format!("{ratio:.5} of the truth"),
            level: None,
            samples: 160 * samples_in_a_pass(&case.scene),
            holds: statistics.rejected == 0 && (ratio - 1.0).abs() < bound,
        }
    });
    settle(&findings);
}

/// A triangle a millionth as wide as long, about `centre`.
fn sliver(sampler: &mut Sampler, centre: Vec3, scale: f32) -> Option<Triangle> {
    let mut direction = || warp::uniform_sphere(sampler.next_2d());
    let (a, along, aside) = (direction(), direction(), direction());
    let middle = a + 0.4 * along + 1e-6 * aside;
    let [a, b, c] = [a, a + along, middle].map(|corner| centre + scale * corner);
    Triangle::new(a, b, c).ok()
}

/// Rays that leave slivers and meet them again, or the same triangle with its
/// corners in another order.
fn self_hits(name: &str, centre: Vec3, scale: f32, count: u64) -> Finding {
    let mut sampler = Sampler::numbered(350, 0);
    let (mut hits, mut left) = (0, 0);
    for _ in 0..count {
        let Some(triangle) = sliver(&mut sampler, centre, scale) else { continue };
        let [a, b, c] = triangle.corners();
        let Ok(turned) = Triangle::new(b, a, c) else { continue };
        let site = Primitive::Triangle(triangle).sample_area(sampler.next_2d());
        let direction = warp::uniform_sphere(sampler.next_2d());
        let ray = Ray::new(site.ray_origin(direction), direction);
        let again = [triangle, turned].map(|shape| shape.intersect(&ray, Sides::Both).is_some());
        hits += again.into_iter().filter(|&hit| hit).count();
        left += 1;
    }
    Finding {
        claim: format!("{name}: no ray that leaves a sliver meets it again"),
        statistic: format!("{hits} of {left}"),
        level: None,
        samples: left,
        holds: hits == 0 && left > count / 2,
    }
}

fn all_self_hits(count: u64) -> Vec<Finding> {
    let scaled =
        SCALES.map(|scale| self_hits(&format!("D10 × {scale:e}"), Vec3::ZERO, scale, count));
    let here = self_hits("D6", Vec3::ZERO, 1.0, count);
    let far = self_hits("D11", FAR, 1.0, count);
    [&scaled[..], &[here, far]].concat()
}

#[test]
fn no_ray_meets_the_sliver_it_left() {
    settle(&all_self_hits(50_000));
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn no_ray_of_millions_meets_the_sliver_it_left() {
    settle(&all_self_hits(1_000_000));
}
