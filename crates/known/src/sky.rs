//! S1 to S3: under the sky.
//!
//! **S1.** What reflects, refracts and passes all light is not to be seen under a sky of radiance
//! 1, and what is convex and reflects the share ρ has the radiance ρ.
//!
//! **S2.** A floor under a picture that nothing hides: E = Σ L·∫cosθ dω over its texels. Over a
//! texel from θ₁ to θ₂ and Δφ wide the integral is Δφ·(sin²θ₂ − sin²θ₁)/2, above the horizon.
//!
//! **S3.** Inside of a ball whose wall passes the share τ straight on and scatters ρ of what
//! arrives, under a sky of radiance 1. From every direction comes the same, L = τ + ρL: paths of
//! K edges, of which a pass-through is none, bring τ·ρ^(K−1).

use crate::case::Case;
use crate::stage::{Stage, ball, camera, camera_of_size, disk, lambert, phong, rectangle, spot};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use traylib_geometry::Vec3;
use traylib_materials::Material;
use traylib_math::{Grid, Rgb};
use traylib_scene::{Camera, Scene};

/// S1: a ball of this material, which leaves this radiance under a sky of 1.
pub fn ball_under_sky(name: &str, material: impl Into<Material>, truth: f64) -> Case {
    let eye = Vec3::new(0.5, 1.0, 3.0);
    let scene = Stage::new(camera(eye, Vec3::ZERO, 30.0, 32))
        .surface(ball(Vec3::ZERO, 2.0), material)
        .sky(Grid::filled(1, 1, Rgb::WHITE), 0.0)
        .build();
    Case { name: format!("S1 {name}"), scene, max_depth: None, truth }
}

/// Columns and rows of the picture of S2.
const SIZE: [usize; 2] = [7, 9];

/// A dark sky with a bright one in part of it, a sun, and light from below.
fn uneven() -> Grid<Rgb> {
    let [width, height] = SIZE;
    Grid::from_fn(width, height, |index| match (index % width, index / width) {
        (3, 2) => Rgb::splat(200.0),
        (0..3, _) => Rgb::splat(1.0 + index as f32 / 20.0),
        (_, 0..4) => Rgb::BLACK,
        _ => Rgb::splat(0.25),
    })
}

/// The irradiance of a floor whose front is up.
fn irradiance_from_above(sky: &Grid<Rgb>) -> f64 {
    let [width, height] = SIZE;
    let squared_sine = |row: usize| (PI * row as f64 / height as f64).min(FRAC_PI_2).sin().powi(2);
    let rows = (0..height).map(|row| {
        let sum: f64 = (0..width).map(|column| f64::from(sky.get(column, row).g)).sum();
        sum * TAU / width as f64 * (squared_sine(row + 1) - squared_sine(row)) / 2.0
    });
    rows.sum()
}

/// S2: a spot of the floor.
pub fn floor_under_picture() -> Case {
    floor("S2 floor", spot(Vec3::new(0.1, 0.5, 0.3), Vec3::ZERO))
}

/// S2: all of a floor, which light paths find.
pub fn whole_floor_under_picture() -> Case {
    floor("S2 whole floor", camera(Vec3::new(0.0, 1.0, 0.0), Vec3::ZERO, 70.0, 32))
}

fn floor(name: &str, camera: Camera) -> Case {
    const REFLECTANCE: f32 = 0.6;
    let sky = uneven();
    let truth = f64::from(REFLECTANCE) / PI * irradiance_from_above(&sky);
    let scene = Stage::new(camera)
        .surface(disk(Vec3::ZERO, Vec3::Y, 1.0), lambert(REFLECTANCE))
        .sky(sky, 25.0)
        .build();
    Case { name: name.into(), scene, max_depth: None, truth }
}

/// Not known in closed form: a wall, a matte and a glossy ball on that floor, where all methods must
/// find the same.
pub fn yard() -> Scene {
    let eye = Vec3::new(0.4, 0.9, 2.2);
    let camera = camera_of_size(eye, Vec3::new(0.0, 0.2, 0.0), 45.0, [48, 36]);
    let wall = rectangle(Vec3::new(-0.8, 0.0, -0.4), 1.2 * Vec3::X, 0.7 * Vec3::Y);
    Stage::new(camera)
        .surface(disk(Vec3::ZERO, Vec3::Y, 2.0), lambert(0.6))
        .surface(wall, lambert(0.8))
        .surface(ball(Vec3::new(-0.4, 0.25, 0.2), 0.25), lambert(0.5))
        .surface(ball(Vec3::new(0.3, 0.3, 0.0), 0.3), phong(0.3, 0.4, 10.0))
        .sky(uneven(), 25.0)
        .build()
}

/// S3: inside of a ball that passes half of the light and scatters the other half.
pub fn translucent_ball(max_depth: Option<u32>) -> Case {
    let wall = Material { through: Rgb::splat(0.5), ..lambert(0.5).into() };
    let scene = Stage::new(camera(Vec3::new(0.1, 0.0, -0.3), Vec3::new(0.2, 0.1, 1.0), 90.0, 32))
        .surface(ball(Vec3::ZERO, 1.0), wall)
        .sky(Grid::filled(1, 1, Rgb::WHITE), 0.0)
        .build();
    // τ·(1 − ρᴷ)/(1 − ρ).
    let truth = 1.0 - max_depth.map_or(0.0, |depth| 0.5_f64.powf(f64::from(depth)));
    Case { name: format!("S3 K = {max_depth:?}"), scene, max_depth, truth }
}
