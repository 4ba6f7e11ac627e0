//! The gain and the cost of paths of each length in bdpt: how much of the light, of the noise and
//! of the rays.

mod rays;
#[cfg(test)]
mod tests;

use crate::results::LengthShare;
use crate::techniques::{edges, weighted_pass};
use traylib_integrators::{Technique, ThreadError};
use traylib_math::{Grid, Rgb};
use traylib_scene::{Film, PassImage, Scene};
use traylib_statistics::own_rel_mse;

/// Lengths told apart; the last stands for all longer ones too.
const LENGTHS: usize = 12;

/// Shares of light, noise and rays by path length, from 1 to 12 edges, of bdpt with
/// the power heuristic and its usual roulette; the last entry holds all paths of 12
/// edges and more. In the size of the scene's camera, from this many passes.
///
/// - light: of the sum over all pixels and bands.
/// - noise: the variance of one pass over r² + ε, r the mean of all passes, summed
///   over pixels and bands, as if lengths were independent: one path lends its
///   vertices to all lengths, so they are not quite.
/// - rays: what a limit of K edges casts beyond one of K − 1, in two passes. Limits
///   spare the rays of longer paths alone, as random numbers are the same.
///
/// A share of nothing is zero: of light in the dark, of noise in one pass.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn lengths(scene: &Scene, epsilon: f64, passes: u32) -> Result<Vec<LengthShare>, ThreadError> {
    let films = films(scene, passes)?;
    let light = shares(&films.each_ref().map(light));
    let whole = whole(&films);
    let variance = shares(&films.each_ref().map(|film| noise(film, &whole, epsilon)));
    let rays = shares(&rays::rays(scene)?);
    let share = |i: usize| LengthShare {
        edges: i as u32 + 1,
        light: light[i],
        variance: variance[i],
        rays: rays[i],
    };
    Ok((0..LENGTHS).map(share).collect())
}

/// The light of each length.
fn films(scene: &Scene, passes: u32) -> Result<[Film; LENGTHS], ThreadError> {
    let (width, height) = (scene.camera().width(), scene.camera().height());
    let mut films = [(); LENGTHS].map(|()| Film::new(width, height));
    for seed in 0..passes {
        let mut images = [(); LENGTHS].map(|()| PassImage::new(width, height));
        for (technique, picture) in weighted_pass(scene, u64::from(seed))? {
            add(&mut images[class(technique)], &picture);
        }
        for (film, image) in films.iter_mut().zip(images) {
            film.add_pass(seed, image);
        }
    }
    Ok(films)
}

fn class(technique: Technique) -> usize {
    (edges(technique) as usize).clamp(1, LENGTHS) - 1
}

/// Most pixels of most techniques are black.
fn add(image: &mut PassImage, picture: &Grid<Rgb>) {
    let pixels = (0..).zip(picture.values());
    for (pixel, &radiance) in pixels.filter(|&(_, &radiance)| radiance != Rgb::BLACK) {
        image.add(pixel, radiance);
    }
}

fn light(film: &Film) -> f64 {
    film.mean().values().as_flattened().iter().sum()
}

/// The mean of all lengths together.
fn whole(films: &[Film; LENGTHS]) -> Vec<[f64; 3]> {
    let means = films.each_ref().map(Film::mean);
    let pixels = means[0].values().len();
    let whole = |i: usize| {
        std::array::from_fn(|band| means.iter().map(|mean| mean.values()[i][band]).sum::<f64>())
    };
    (0..pixels).map(whole).collect()
}

/// The noise of a length, by what the whole picture is; none in one pass.
fn noise(film: &Film, whole: &[[f64; 3]], epsilon: f64) -> f64 {
    film.variance_of_mean().map_or(0.0, |variance| own_rel_mse(whole, variance.values(), epsilon))
}

fn shares(parts: &[f64; LENGTHS]) -> [f64; LENGTHS] {
    let whole: f64 = parts.iter().sum();
    parts.map(|part| if whole > 0.0 { part / whole } else { 0.0 })
}
