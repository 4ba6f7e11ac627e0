use super::*;
use traylib_math::Sampler;

const WIDTH: usize = 96;
const HEIGHT: usize = 64;

/// Light that falls off, a sharp edge, and squares of one pixel in a corner.
fn scene(x: usize, y: usize) -> Vec3 {
    let shade = 0.2 + 0.01 * x as f32;
    let lit = if x + 2 * y > 90 { 1.0 } else { 0.3 };
    let detail = if x < 24 && y > 40 && (x + y).is_multiple_of(2) { 3.0 } else { 1.0 };
    Vec3::new(1.0, 0.8, 0.5) * (shade * lit * detail)
}

fn noisy(noise: f32, sampler: &mut Sampler) -> Picture {
    Grid::from_fn(WIDTH, HEIGHT, |i| {
        let exact = scene(i % WIDTH, i / WIDTH);
        // The sum of twelve uniform numbers less their mean has a variance of one.
        let normal = (0..12).map(|_| sampler.next_1d()).sum::<f32>() - 6.0;
        exact * (1.0 + noise * normal).max(0.0)
    })
}

fn rel_mse(picture: &Grid<Rgb>) -> f64 {
    let errors = picture.values().iter().enumerate().map(|(i, light)| {
        let exact = scene(i % WIDTH, i / WIDTH);
        let error = Vec3::from(light.to_array()) - exact;
        f64::from((error / exact).length_squared())
    });
    errors.sum::<f64>() / (WIDTH * HEIGHT) as f64
}

/// However much noise there is, a part of it goes; where there is none next to nothing does.
#[test]
fn noise_goes_and_edges_stay() {
    for (noise, most) in [(0.5, 0.1), (0.1, 0.2), (0.01, 0.5)] {
        let mut sampler = Sampler::numbered(3, 0);
        let pictures = [0, 1].map(|_| noisy(noise, &mut sampler));
        let halves = Halves { pictures, parts: [0.5, 0.5] };
        let whole = mix(&halves.pictures[0], &halves.pictures[1], halves.parts);
        let before = rel_mse(&whole.map(|light| Rgb::from(light.to_array())));
        let after = rel_mse(&denoise(&halves));
        assert!(after < most * before, "{noise}: {before} {after}");
    }
}

#[test]
fn light_without_noise_is_left_alone() {
    let exact = Grid::from_fn(WIDTH, HEIGHT, |i| scene(i % WIDTH, i / WIDTH));
    let halves = Halves { pictures: [exact.clone(), exact], parts: [0.25, 0.75] };
    assert!(rel_mse(&denoise(&halves)) < 1e-9);
    let black = Grid::filled(5, 3, Vec3::ZERO);
    let halves = Halves { pictures: [black.clone(), black], parts: [0.5, 0.5] };
    assert!(denoise(&halves).values().iter().all(|light| light.is_black()));
}

/// A single spark is spread, and takes no light from anywhere.
#[test]
fn light_is_kept() {
    let mut sampler = Sampler::numbered(4, 0);
    let mut pictures = [0, 1].map(|_| noisy(0.3, &mut sampler));
    pictures[0].values_mut()[20 * WIDTH + 60] = Vec3::splat(300.0);
    let halves = Halves { pictures, parts: [0.5, 0.5] };
    let sum = |picture: &Picture| picture.values().iter().map(|l| f64::from(l.x)).sum::<f64>();
    let before = 0.5 * (sum(&halves.pictures[0]) + sum(&halves.pictures[1]));
    let after: f64 = denoise(&halves).values().iter().map(|light| f64::from(light.r)).sum();
    assert!((after / before - 1.0).abs() < 0.1, "{before} {after}");
}
