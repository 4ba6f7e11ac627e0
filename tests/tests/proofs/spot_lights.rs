//! A spot light over a diffuse floor: radiance ρ/π·I·S(θ)·cosα/d², with S = 1 in the
//! full part of the cone.

use std::f64::consts::{FRAC_1_PI, PI};
use traylib_geometry::Vec3;
use traylib_integrators::Trace;
use traylib_known::stage::{Stage, camera, lambert, rectangle, spot};
use traylib_known::{Case, mean_over_floor, pass_means, samples_in_a_pass, settings_by_pass};
use traylib_scene::{Camera, Scene, SpotCone};
use traylib_tests::findings::settle;
use traylib_tests::measure::{EQUIVALENCE, Measured, all_hold, judge};
use traylib_tests::methods;

const PASSES: u32 = 192;
const REFLECTANCE: f64 = 0.5;
const INTENSITY: f64 = 7.0;
const LAMP: Vec3 = Vec3::new(0.5, 0.0, 2.0);
/// Angles from the axis.
const FULL: f64 = PI / 8.0;
const DARK: f64 = PI / 6.0;

/// Leaning, as a slope of 3 in 4.
fn cone() -> SpotCone {
    let [cos_full, cos_dark] = [FULL, DARK].map(|angle| angle.cos() as f32);
    SpotCone { axis: Vec3::new(-0.6, 0.0, -0.8), cos_full, cos_dark }
}

/// Over a small floor: the place of a hit is known to 2⁻²⁴ of the edges, and the
/// falloff changes within centimetres.
fn lit(camera: Camera) -> Scene {
    let floor = rectangle(Vec3::new(-4.0, -4.0, 0.0), 8.0 * Vec3::X, 8.0 * Vec3::Y);
    Stage::new(camera)
        .surface(floor, lambert(REFLECTANCE as f32))
        .spot_light(LAMP, INTENSITY as f32, cone())
        .build()
}

/// ρ/π·I·S·cosα/d² with the smooth step S of the angle.
fn radiance(x: Vec3) -> f64 {
    let offset = (x - LAMP).as_dvec3();
    let distance = offset.length();
    let theta = offset.angle_between(cone().axis.as_dvec3());
    let t = ((DARK - theta) / (DARK - FULL)).clamp(0.0, 1.0);
    let falloff = t * t * (3.0 - 2.0 * t);
    let cosine = -offset.z / distance;
    REFLECTANCE * FRAC_1_PI * INTENSITY * falloff * cosine / (distance * distance)
}

/// A place that the lamp lights fully and one half way to the dark, from walks of
/// every kind.
#[test]
fn places_have_their_radiance() {
    let middle = f64::midpoint(FULL, DARK);
    // The axis meets the floor at x = −1, at an angle of atan(3/4) from the vertical.
    let across = |angle: f64| 0.5 - 2.0 * (0.75_f64.atan() - angle).tan();
    for (name, x, falloff) in [("full", -1.0, 1.0), ("half", across(middle), 0.5)] {
        let place = Vec3::new(x as f32, 0.0, 0.0);
        let distance_squared = 4.0 + (x - 0.5).powi(2);
        let irradiance = INTENSITY * falloff * 2.0 / distance_squared.powf(1.5);
        let case = Case {
            name: format!("spot light, {name}"),
            scene: lit(spot(place + Vec3::new(0.3, 0.4, 1.0), place)),
            max_depth: Some(2),
            truth: REFLECTANCE * FRAC_1_PI * irradiance,
        };
        all_hold(&case, 60, &methods::from_camera(4));
    }
}

/// The whole of the light and the dark around it: `trace`, light paths and both
/// ways together.
#[test]
fn a_lit_floor_is_the_same_from_both_ends() {
    let view = camera(Vec3::new(-1.0, 0.0, 5.0), Vec3::new(-1.0, 0.0, 0.0), 60.0, 32);
    let truth = mean_over_floor(&view, radiance);
    let scene = lit(view);
    let settings = settings_by_pass(PASSES, 61);
    let (means, statistics) = pass_means(&scene, &Trace { jitter: true }, &settings);
    let samples = u64::from(PASSES) * samples_in_a_pass(&scene);
    let traced = Measured { means, statistics, samples };
    settle(&[judge("spot light, floor, trace".into(), &traced, truth, EQUIVALENCE)]);
    let case = Case { name: "spot light, floor".into(), scene, max_depth: Some(2), truth };
    let methods =
        [(methods::PARTICLE, 600), (methods::BDPT, PASSES), (methods::DIRECT_LIGHT, PASSES)];
    all_hold(&case, 62, &methods);
}
