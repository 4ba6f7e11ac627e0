//! The contributions of the techniques of bdpt, one by one.

use std::ops::ControlFlow;
use traylib_integrators::{
    Bdpt, Control, Limits, Report, Settings, Technique, ThreadError, render,
};
use traylib_math::{Grid, Rgb};
use traylib_scene::Scene;

/// Edges of the longest paths that are shown.
const MOST_EDGES: u32 = 6;

/// A picture of each technique for paths of up to six edges that brought any light,
/// raw and weighted (power heuristic), in the size of the scene's camera: sorted by
/// edges, then vertices from the light, then raw before weighted.
///
/// # Errors
/// [`ThreadError`] if the system refuses the threads.
pub fn technique_pictures(
    scene: &Scene,
    passes: u32,
) -> Result<Vec<(Technique, Grid<Rgb>)>, ThreadError> {
    let limits = Limits { max_depth: Some(MOST_EDGES), ..Limits::default() };
    let settings = Settings { spp: passes, seed: 0, threads: 0, ..Settings::default() };
    let mut pictures = layers(scene, limits, &settings, |_| true)?;
    let pair = |technique: &Technique| (technique.s, technique.t, technique.by_mirror);
    let lit: Vec<(u8, u8, bool)> = pictures
        .iter()
        .filter(|(_, picture)| picture.values().iter().any(|pixel| pixel.max_band() > 0.0))
        .map(|(technique, _)| pair(technique))
        .collect();
    pictures.retain(|(technique, _)| lit.contains(&pair(technique)));
    pictures.sort_by_key(|&(technique, _)| {
        let Technique { s, by_mirror, weighted, .. } = technique;
        (edges(technique), s, by_mirror, weighted)
    });
    Ok(pictures)
}

/// The weighted picture of every technique, for paths of any length, from one pass.
pub(crate) fn weighted_pass(
    scene: &Scene,
    seed: u64,
) -> Result<Vec<(Technique, Grid<Rgb>)>, ThreadError> {
    let settings = Settings { spp: 1, seed, threads: 0, ..Settings::default() };
    layers(scene, Limits::default(), &settings, |technique| technique.weighted)
}

/// Edges of the paths that a technique makes: s + t vertices.
pub(crate) fn edges(technique: Technique) -> u32 {
    (u32::from(technique.s) + u32::from(technique.t)).saturating_sub(1)
}

fn layers(
    scene: &Scene,
    limits: Limits,
    settings: &Settings,
    wanted: impl Fn(Technique) -> bool,
) -> Result<Vec<(Technique, Grid<Rgb>)>, ThreadError> {
    let bdpt = Bdpt { limits, report: Report::Techniques, ..Bdpt::default() };
    let rendering =
        render(scene, &bdpt, settings, &Control::default(), &mut |_| ControlFlow::Continue(()))?;
    let layers = rendering.film.develop_layers().into_iter();
    let pictures = layers.map(|(layer, picture)| (Technique::of_layer(layer), picture));
    Ok(pictures.filter(|&(technique, _)| wanted(technique)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_known::furnace::{diffuse_walls, glowing_ball};

    fn pictures() -> Vec<(Technique, Grid<Rgb>)> {
        technique_pictures(&glowing_ball(diffuse_walls(), None).scene, 8).unwrap()
    }

    #[test]
    fn they_come_in_order_and_in_pairs() {
        let pictures = pictures();
        let keys: Vec<_> = pictures
            .iter()
            .map(|&(technique, _)| (edges(technique), technique.s, technique.weighted))
            .collect();
        assert!(keys.is_sorted());
        assert_eq!((keys[0].0, keys[keys.len() - 1].0), (1, MOST_EDGES));
        assert!(keys.chunks(2).all(|pair| !pair[0].2 && pair[1].2 && pair[0].1 == pair[1].1));
        for (technique, picture) in pictures {
            let light: f32 = picture.values().iter().map(|pixel| pixel.g).sum();
            assert!(technique.weighted || light > 0.0, "{technique:?}");
        }
    }

    /// Every wall glows with 1 and keeps 0.5, so paths of K edges bring 0.5^(K−1), and
    /// the technique without a light path brings it all by itself.
    #[test]
    fn each_length_adds_up_to_its_light() {
        let pictures = pictures();
        for length in 1..=3 {
            let mean = |wanted: &dyn Fn(Technique) -> bool| {
                let of = pictures.iter().filter(|(t, _)| edges(*t) == length && wanted(*t));
                let pixels = of.flat_map(|(_, picture)| picture.values());
                f64::from(pixels.map(|pixel| pixel.g).sum::<f32>()) / 1024.0
            };
            let expected = 0.5_f64.powf(f64::from(length) - 1.0);
            for found in [mean(&|t| t.weighted), mean(&|t| !t.weighted && t.s == 0)] {
                assert!((found / expected - 1.0).abs() < 0.05, "{length}: {found} {expected}");
            }
        }
    }
}
