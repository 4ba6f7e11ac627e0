//! F8: a thousand lamps, one of them relevant, over a floor z = 0.
//!
//! Light is picked by power, nearness and side. Whether that is right depends on why
//! the other 999 do not matter, so there are three scenes. In F8 and F8p they are
//! weak, a tenth of all power together: power knows. In F8b they are as strong as
//! the one and shine on the upper side of a black ceiling: power, by which light
//! paths start, knows nothing.

use crate::stability::closed::disk_factor;
use std::f64::consts::PI;
use traylib_geometry::Vec3;
use traylib_known::stage::{Stage, black, camera, disk_facing_down, floor, lambert, rectangle};
use traylib_scene::{Camera, Scene};

const REFLECTANCE: f64 = 0.5;
const OTHERS: u32 = 999;
/// The power of each weak lamp, over that of the relevant one.
const WEAKNESS: f64 = 1e-4;
/// The radius of the weak lamps: its square carries that ratio at equal radiance.
const WEAK_RADIUS: f64 = 0.01;

/// F8: the relevant lamp is a disk of radius 1 at the height 1, the others disks
/// of a hundredth of that around it.
pub fn weak() -> Scene {
    let stage = diffuse_floor(32).light(disk_facing_down(Vec3::Z, 1.0), 1.0, black());
    let small = |stage: Stage, at: Vec3| {
        stage.light(disk_facing_down(at, WEAK_RADIUS as f32), 1.0, black())
    };
    around().fold(stage, small).build()
}

/// F8b: the others lie above a ceiling at the height 1.2.
pub fn hidden() -> Scene {
    let ceiling = rectangle(Vec3::new(-64.0, -64.0, 1.2), 128.0 * Vec3::X, 128.0 * Vec3::Y);
    let stage = diffuse_floor(32).surface(ceiling, black()).light(
        disk_facing_down(Vec3::Z, 1.0),
        1.0,
        black(),
    );
    let above = |stage: Stage, at: Vec3| stage.light(disk_facing_down(4.0 * at, 1.0), 1.0, black());
    around().fold(stage, above).build()
}

/// F8p: point lights, for `trace`.
pub fn points() -> Scene {
    let stage = diffuse_floor(16).point(Vec3::Z, 1.0);
    around().fold(stage, |stage, at| stage.point(at, WEAKNESS as f32)).build()
}

/// F8: ρ times the sum of all form factors.
pub fn weak_radiance(origin: Vec3, direction: Vec3) -> f64 {
    let x = floor_point(origin, direction);
    let others: f64 = around().map(|at| disk_factor(aside(x, at), WEAK_RADIUS, 1.0)).sum();
    REFLECTANCE * (disk_factor(aside(x, Vec3::Z), 1.0, 1.0) + others)
}

/// F8b: the relevant lamp alone.
pub fn one_radiance(origin: Vec3, direction: Vec3) -> f64 {
    let x = floor_point(origin, direction);
    REFLECTANCE * disk_factor(aside(x, Vec3::Z), 1.0, 1.0)
}

/// F8p: ρ/π times the sum of I/d³ at the height 1.
pub fn points_radiance(origin: Vec3, direction: Vec3) -> f64 {
    let x = floor_point(origin, direction);
    let one = |at: Vec3| (1.0 + aside(x, at).powi(2)).powf(-1.5);
    let others: f64 = around().map(one).sum();
    REFLECTANCE / PI * (one(Vec3::Z) + WEAKNESS * others)
}

/// The places of the others, at the height 1: a spiral of equal areas from 1.1 m
/// to 3 m around the relevant lamp.
fn around() -> impl Iterator<Item = Vec3> {
    let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
    (0..OTHERS).map(move |i| {
        let part = (f64::from(i) + 0.5) / f64::from(OTHERS);
        let radius = (1.1 * 1.1 + part * (3.0 * 3.0 - 1.1 * 1.1)).sqrt();
        let (y, x) = (golden_angle * f64::from(i)).sin_cos();
        Vec3::new((radius * x) as f32, (radius * y) as f32, 1.0)
    })
}

fn diffuse_floor(size: u32) -> Stage {
    Stage::new(view(size)).surface(floor(), lambert(REFLECTANCE as f32))
}

/// Straight down from below the lamps.
fn view(size: u32) -> Camera {
    camera(Vec3::new(0.1, 0.0, 0.8), Vec3::new(0.1, 0.0, 0.0), 60.0, size)
}

fn floor_point(origin: Vec3, direction: Vec3) -> Vec3 {
    origin - direction * (origin.z / direction.z)
}

/// Returns the distance of a lamp's axis from a point of the floor.
fn aside(x: Vec3, lamp: Vec3) -> f64 {
    f64::from(x.x - lamp.x).hypot(f64::from(x.y - lamp.y))
}
