//! A scene and the mean radiance that it should have.

use traylib_geometry::Vec3;
use traylib_math::Vec2;
use traylib_scene::{Camera, Scene};

/// A scene whose mean radiance over the film is known.
#[derive(Debug)]
pub struct Case {
    /// The name of the case in a report.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The longest path, in edges.
    pub max_depth: Option<u32>,
    /// The mean radiance, in W/m²/sr.
    pub truth: f64,
}

/// The mean over the film of what is seen at the points of the plane z = 0, by
/// the midpoint rule on 512 × 512 film points. The camera must see the plane
/// everywhere.
pub fn mean_over_floor(camera: &Camera, radiance: impl Fn(Vec3) -> f64) -> f64 {
    mean_over_film(camera, |origin, direction| {
        radiance(origin - direction * (origin.z / direction.z))
    })
}

/// The mean over the film of what is seen from the camera into a direction, by
/// the midpoint rule on 512 × 512 film points.
pub fn mean_over_film(camera: &Camera, radiance: impl Fn(Vec3, Vec3) -> f64) -> f64 {
    const STEPS: u32 = 512;
    let film = Vec2::new(camera.width() as f32, camera.height() as f32);
    let sum: f64 = (0..STEPS * STEPS)
        .map(|i| {
            let middle = Vec2::new((i % STEPS) as f32 + 0.5, (i / STEPS) as f32 + 0.5);
            let direction = camera.ray(film * middle / STEPS as f32).direction;
            radiance(camera.position(), direction)
        })
        .sum();
    sum / f64::from(STEPS * STEPS)
}
