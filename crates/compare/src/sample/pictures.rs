//! Made-up pictures: a soft light on a wall with a disk in front, and noise.

use crate::pictures::ScenePictures;
use crate::results::{MethodResults, SceneResults};
use traylib_integrators::Technique;
use traylib_math::{Grid, Rgb};
use traylib_statistics::relative_square_errors;

/// The pictures of a made-up scene.
pub(super) fn of(scene: &SceneResults) -> ScenePictures {
    let (width, height) = (scene.width as usize, scene.height as usize);
    let reference = picture(width, height, |light, _| light);
    let methods: Vec<_> = scene.methods.iter().map(|m| noisy(m, width, height)).collect();
    let errors = methods.iter().map(|x| errors(x, &reference, scene.epsilon)).collect();
    let outside = scene.outside.iter().map(|_| picture(width, height, |l, u| l + 0.1 * u));
    ScenePictures {
        exposure: 1.5,
        outside: outside.collect(),
        techniques: techniques(),
        reference,
        methods,
        errors,
    }
}

fn noisy(method: &MethodResults, width: usize, height: usize) -> Grid<Rgb> {
    let deviation = method.metrics.rel_mse.sqrt() as f32;
    let kept = 1.0 + method.metrics.bias as f32;
    picture(width, height, |light, u| light * (kept + 1.7 * deviation * u))
}

/// `of` the light of each pixel and a number in [−1, 1].
fn picture(width: usize, height: usize, of: impl Fn(f32, f32) -> f32) -> Grid<Rgb> {
    let mut state = 1_u32;
    let mut number = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / (1 << 23) as f32 - 1.0
    };
    let mut grid = Grid::filled(width, height, Rgb::BLACK);
    for (i, pixel) in grid.values_mut().iter_mut().enumerate() {
        let at = |k: usize, of: usize| 2.0 * (k as f32 + 0.5) / of as f32 - 1.0;
        let (light, tint) = wall(at(i % width, width), at(i / width, height));
        *pixel = of(light, number()).max(0.0) * tint;
    }
    grid
}

fn wall(x: f32, y: f32) -> (f32, Rgb) {
    let light = 0.05 + 0.5 / (1.0 + 2.0 * x * x + 3.0 * (y + 0.6).powi(2));
    let in_disk = (x - 0.3).powi(2) + (y - 0.2).powi(2) < 0.12;
    (light, if in_disk { Rgb::new(0.9, 0.45, 0.2) } else { Rgb::new(0.6, 0.75, 0.85) })
}

fn errors(x: &Grid<Rgb>, reference: &Grid<Rgb>, epsilon: f64) -> Grid<f64> {
    let grey = |of: &Grid<Rgb>| of.map(|light| [f64::from(light.luminance())]);
    let values = relative_square_errors(grey(x).values(), grey(reference).values(), epsilon);
    Grid::from_values(x.width(), x.height(), values.unwrap_or_default())
        .unwrap_or_else(|| Grid::filled(x.width(), x.height(), 0.0))
}

fn techniques() -> Vec<(Technique, Grid<Rgb>)> {
    let mut all = Vec::new();
    for edges in 1..=5_u8 {
        for s in 0..=edges {
            for weighted in [false, true] {
                let share = if weighted { 1.0 / f32::from(edges + 1) } else { 1.0 };
                let grid = picture(32, 24, |light, u| light * share * (1.0 + 0.3 * u));
                let (t, by_mirror) = (edges + 1 - s, false);
                all.push((Technique { s, t, by_mirror, weighted }, grid));
            }
        }
    }
    all
}
