//! Closed rooms with known radiance, for all lengths of paths and for each.
//!
//! In a room whose walls all reflect the share ρ of what arrives and emit Le, the
//! same radiance L in every direction satisfies L = Le + ρL, whatever the shape
//! of the room: L = Le/(1 − ρ). Paths of at most K edges carry the first K terms
//! of that geometric series, Le·(1 − ρᴷ)/(1 − ρ). It does not matter which part
//! of ρ is diffuse and which an ideal mirror.

use crate::case::{Case, mean_over_film};
use crate::stage::{Stage, camera, hollow_ball, hollow_cube, lambert, mirror, spot};
use std::f64::consts::PI;
use traylib_geometry::Vec3;
use traylib_materials::SurfaceModel;
use traylib_scene::{Camera, Scene};

const REFLECTANCE: f64 = 0.5;
const OFFSET: f64 = 0.5;

/// Le = 1 everywhere on diffuse walls with ρ = 0.5: L = 2, and 1.875 for K = 4.
pub fn diffuse_walls() -> SurfaceModel {
    lambert(REFLECTANCE as f32)
}

/// ρ = 0.3 mirror + 0.2 diffuse, the same sums.
pub fn mirroring_walls() -> SurfaceModel {
    mirror(0.3, 0.2)
}

/// B1, B2: inside a glowing ball.
pub fn glowing_ball(walls: SurfaceModel, max_depth: Option<u32>) -> Case {
    let scene = Stage::new(wide_view()).light(hollow_ball(Vec3::ZERO, 1.0), 1.0, walls).build();
    Case { name: format!("B ball K = {max_depth:?}"), scene, max_depth, truth: glow(max_depth) }
}

/// B1, B2: inside a glowing cube. (Quads that merely touch let about one ray in
/// ten million through, far below what is measured here.)
pub fn glowing_cube(walls: SurfaceModel, max_depth: Option<u32>) -> Case {
    let scene = hollow_cube(1.0)
        .into_iter()
        .fold(Stage::new(wide_view()), |stage, side| stage.light(side, 1.0, walls))
        .build();
    Case { name: format!("B cube K = {max_depth:?}"), scene, max_depth, truth: glow(max_depth) }
}

/// (1 − ρᴷ)/(1 − ρ) for Le = 1.
fn glow(max_depth: Option<u32>) -> f64 {
    (1.0 - power_of_reflectance(max_depth)) / (1.0 - REFLECTANCE)
}

/// ρᴷ; zero without a limit.
fn power_of_reflectance(max_depth: Option<u32>) -> f64 {
    max_depth.map_or(0.0, |depth| REFLECTANCE.powf(f64::from(depth)))
}

/// B4: a point light of I = π in the middle of a ball of radius 1. All points
/// receive I/R² directly and ρ times as much again after each reflection, since
/// what they see has the same radiance everywhere:
/// L = ρ/π·I/(1 − ρ) = 1. A path of two edges is the first term, so K edges carry
/// K − 1 terms: 1 − ρ^(K−1).
pub fn central_light(max_depth: Option<u32>) -> Case {
    let truth = 1.0 - power_of_reflectance(max_depth.map(|depth| depth - 1));
    let scene = lit_ball(wide_view(), Vec3::ZERO);
    Case { name: format!("B4 K = {max_depth:?}"), scene, max_depth, truth }
}

/// B5: the light half way to the wall, seen at the angle `degrees` from it as
/// seen from the centre; see [`radiance_of_offset_light`].
pub fn offset_light(degrees: f64, max_depth: Option<u32>) -> Case {
    let angle = degrees.to_radians();
    let target = Vec3::new(angle.sin() as f32, 0.0, angle.cos() as f32);
    let scene = lit_ball(spot(Vec3::new(-0.2, 0.3, -0.1), target), OFFSET as f32 * Vec3::Z);
    let truth = radiance_of_offset_light(angle.cos(), max_depth);
    Case { name: format!("B5 {degrees}° K = {max_depth:?}"), scene, max_depth, truth }
}

/// B5 in a wide view: a quarter turn about the point nearest to the light.
pub fn offset_light_wide(max_depth: Option<u32>) -> Case {
    let camera = camera(Vec3::new(0.1, 0.0, -0.3), Vec3::new(0.2, 0.1, 1.0), 90.0, 32);
    let truth = mean_over_film(&camera, |origin, direction| {
        // The far end of the chord: |o + t·d| = 1.
        let along = f64::from(origin.dot(direction));
        let inside = f64::from(origin.length_squared()) - 1.0;
        let chord = -along + (along * along - inside).sqrt();
        let z = f64::from(origin.z) + chord * f64::from(direction.z);
        radiance_of_offset_light(z, max_depth)
    });
    let scene = lit_ball(camera, OFFSET as f32 * Vec3::Z);
    Case { name: format!("B5 wide K = {max_depth:?}"), scene, max_depth, truth }
}

/// Returns the radiance of a point of the ball whose direction from the centre makes an
/// angle of this cosine with that of the light; I = π, R = 1, a = 0.5.
///
/// Directly, E = I·cosθ/r², with r² = R² + a² − 2Ra·cosφ and the incidence from
/// the triangle centre, light, point: cosθ = (R² + r² − a²)/(2Rr).
///
/// Any two patches of a ball exchange the same share of light, dA/(4πR²), since
/// the cosines are both r/(2R). So after one reflection light is spread evenly:
/// ρ·4πI over 4πR², and ρ times as much after each further one. In all
/// L = ρ/π·[E + I/R²·(ρ + ρ² + …)], with K − 2 terms in the sum for K edges.
pub fn radiance_of_offset_light(cos_phi: f64, max_depth: Option<u32>) -> f64 {
    let r_squared = 1.0 + OFFSET * OFFSET - 2.0 * OFFSET * cos_phi;
    let r = r_squared.sqrt();
    let cos_theta = (1.0 + r_squared - OFFSET * OFFSET) / (2.0 * r);
    let lost = power_of_reflectance(max_depth.map(|depth| depth - 2));
    let series = REFLECTANCE * (1.0 - lost) / (1.0 - REFLECTANCE);
    REFLECTANCE * (cos_theta / r_squared + series)
}

fn lit_ball(camera: Camera, light: Vec3) -> Scene {
    let ball = hollow_ball(Vec3::ZERO, 1.0);
    Stage::new(camera).surface(ball, diffuse_walls()).point(light, PI as f32).build()
}

/// A quarter turn from beside the middle: the radiance is the same everywhere,
/// and a sixth of all light ends up in view.
fn wide_view() -> Camera {
    camera(Vec3::new(0.1, -0.05, 0.15), Vec3::new(0.3, 1.0, -0.2), 90.0, 32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_have_their_known_values() {
        assert_eq!(glow(None), 2.0);
        assert_eq!(glow(Some(4)), 1.875);
        assert_eq!(central_light(None).truth, 1.0);
        assert_eq!(central_light(Some(5)).truth, 0.9375);
        for (cos_phi, depth, known) in [
            (1.0, None, 2.5),
            (1.0, Some(5), 2.4375),
            (0.5, None, 1.077_350),
            (0.0, None, 0.857_771),
            (-1.0, None, 0.722_222),
            (-1.0, Some(5), 0.659_722),
        ] {
            let found = radiance_of_offset_light(cos_phi, depth);
            assert!((found - known).abs() < 1e-6, "{cos_phi} {depth:?}: {found}");
        }
    }

    /// Paths of two edges from the light straight to the wall must bring in all
    /// that it emits: the mean of E over the wall is 4πI/(4πR²) = I.
    #[test]
    fn direct_light_on_the_wall_is_all_there_is() {
        let steps = 10_000;
        // Area is uniform in the cosine.
        let sum: f64 = (0..steps)
            .map(|i| -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(steps))
            .map(|cos_phi| radiance_of_offset_light(cos_phi, Some(2)) / REFLECTANCE)
            .sum();
        assert!((sum / f64::from(steps) - 1.0).abs() < 1e-5, "{sum}");
    }
}
