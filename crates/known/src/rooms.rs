//! More closed rooms: glossy walls, and what all walls together receive.

use crate::case::Case;
use crate::lobe::Lobe;
use crate::stage::{Stage, camera, hollow_ball, hollow_cube, lambert, phong, spot};
use std::f64::consts::PI;
use traylib_geometry::Vec3;

/// B3: inside a ball that glows with radiance 1 everywhere, to two edges. What a
/// wall reflects of a radiance that is the same everywhere is its albedo for the
/// direction it is seen from, whatever its BRDF (Szirmay-Kalos et al., *Testing
/// Monte-Carlo global illumination methods with analytically computable
/// scenes*, 2001): L = 1 + kd + ks·A(θ, n), with A the albedo of the lobe alone.
///
/// A longer path would need what the walls reflect to be the same everywhere
/// too, so lamps that emit less where the albedo is higher.
pub fn glossy_ball(exponent: f32, degrees: f64) -> Case {
    let (diffuse, specular) = (0.3, 0.6);
    let angle = degrees.to_radians();
    let toward_eye = Vec3::new(angle.sin() as f32, 0.0, angle.cos() as f32);
    // The middle of the chord that leaves the lowest point at this angle.
    let eye = Vec3::NEG_Z + angle.cos() as f32 * toward_eye;
    let walls = phong(diffuse as f32, specular as f32, exponent);
    let scene =
        Stage::new(spot(eye, Vec3::NEG_Z)).light(hollow_ball(Vec3::ZERO, 1.0), 1.0, walls).build();
    let truth = 1.0 + diffuse + specular * Lobe::new(exponent, toward_eye).phong_albedo();
    Case { name: format!("B3 n = {exponent}, {degrees}°"), scene, max_depth: Some(2), truth }
}

/// B7: a cube of half-side 1 and reflectance ρ = 0.5 with a point light of flux
/// P = 4πI, I = π, off its middle: the mean over all walls of the radiance, as
/// six cameras in the middle see it; a quarter turn fills the film with one
/// wall, equal parts of the film with equal areas.
///
/// The walls give back the share ρ of what arrives, all of which arrives again:
/// in all P·(1 + ρ + ρ² + …) over the area S, whatever the shape of the room and
/// wherever the light is. Reflected once more, L = ρ/π·P/(S·(1 − ρ)).
///
/// One case for each wall; the truth is that of all six together.
pub fn room_of_flux() -> [Case; 6] {
    let (reflectance, area) = (0.5, 24.0);
    let truth = reflectance / PI * 4.0 * PI * PI / (area * (1.0 - reflectance));
    [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z].map(|wall| {
        let stage = Stage::new(camera(Vec3::ZERO, wall, 90.0, 32));
        let walls = hollow_cube(1.0).into_iter();
        let room =
            walls.fold(stage, |stage, side| stage.surface(side, lambert(reflectance as f32)));
        let scene = room.point(Vec3::new(0.3, -0.2, 0.5), PI as f32).build();
        Case { name: format!("B7 {wall}"), scene, max_depth: None, truth }
    })
}
