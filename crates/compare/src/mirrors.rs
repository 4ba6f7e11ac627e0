//! Finds where a picture shows mirrors, which a particle tracer cannot render.

use traylib_math::{Grid, Vec2};
use traylib_scene::Scene;

/// Points of a pixel, along each side, that are looked through.
const STEPS: u32 = 8;

/// Tells whether a pixel or a neighbour of it sees a surface that reflects ideally.
pub(crate) fn mirrors(scene: &Scene) -> Grid<bool> {
    let (width, height) = (scene.camera().width(), scene.camera().height());
    let seen: Vec<bool> =
        (0..width * height).map(|i| sees_mirror(scene, i % width, i / width)).collect();
    let near = |i: u32| {
        let (x, y) = (i % width, i / width);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        let mut rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.any(|y| columns.clone().any(|x| seen[(y * width + x) as usize]))
    };
    let values = (0..width * height).map(near).collect();
    Grid::from_values(width as usize, height as usize, values).expect("one value a pixel")
}

fn sees_mirror(scene: &Scene, x: u32, y: u32) -> bool {
    let corner = Vec2::new(x as f32, y as f32);
    (0..STEPS * STEPS).any(|i| {
        let inside = Vec2::new((i % STEPS) as f32 + 0.5, (i / STEPS) as f32 + 0.5) / STEPS as f32;
        let hit = scene.intersect(&scene.camera().ray(corner + inside));
        hit.is_some_and(|point| point.model.has_delta_part())
    })
}
