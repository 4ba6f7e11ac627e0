//! Methods against one another on the same scene.
//!
//! Welch's test on tiles and on the image mean, decided at fixed looks after
//! 1, 4 and 16 times the first number of passes, the level split among them: a
//! pair that is shown to be the same early is left, one that differs is seen in
//! the end. "No difference found" is not enough: the interval of the ratio of the
//! means must lie within what the pair promises.
//!
//! Light that only rare chance finds has no usable variance: a floor lit by way
//! of a mirror and seen in one, a small lamp in `puremc`. A tile where one pass
//! makes up much of the variance is left out and counted.

use crate::findings::Finding;
use crate::methods;
use traylib_integrators::{BlindSpot, Method, SceneFacts, Settings};
use traylib_known::{each_pass, samples_in_a_pass, settings_by_pass};
use traylib_math::Vec2;
use traylib_scene::Scene;
use traylib_statistics::student::two_sided_quantile;
use traylib_statistics::{Sample, batch_means, holm, tile_means, uniformity, welch};

/// Chance of a false alarm among all tiles and looks of one scene.
pub const SCENE_LEVEL: f64 = 1e-4;
const BATCHES: usize = 32;
/// The largest part of a tile's variance that one pass may make up. Of n normal
/// values the largest makes up about 2·ln n/n.
const CHANCE: f64 = 0.15;
/// The level of the interval that has to lie within the promise.
const EQUIVALENCE_LEVEL: f64 = 1e-3;

/// A method to hold against `bdpt`.
#[derive(Clone, Copy, Debug)]
pub struct Other {
    /// The method.
    pub method: Method,
    /// The number of its passes that go with one of `bdpt`.
    pub passes: u32,
    /// The distance from one within which the ratio of the means and its interval must lie.
    pub promise: f64,
}

/// The amount to render.
#[derive(Clone, Debug)]
pub struct Budget {
    /// Side of a tile in pixels.
    pub tile: usize,
    /// Passes of `bdpt` up to each look.
    pub looks: Vec<u32>,
}

/// A scene by name, already loaded.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The name of the scene in a report.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a Scene,
}

/// The outcome of one scene.
#[derive(Debug, Default)]
pub struct Agreement {
    /// The claims.
    pub findings: Vec<Finding>,
    /// The probabilities of Welch's test for the tiles at the last look, a list a
    /// method.
    pub p_values: Vec<(Method, Vec<f64>)>,
}

/// Holds methods against `bdpt` on one scene.
pub fn agree(subject: &Subject<'_>, others: &[Other], budget: &Budget) -> Agreement {
    let mut bdpt = Tiles::new(subject, methods::BDPT, budget.tile);
    let mut open: Vec<(Other, Tiles)> =
        others.iter().map(|&o| (o, Tiles::new(subject, o.method, budget.tile))).collect();
    let mut done = Agreement::default();
    let level = SCENE_LEVEL / (budget.looks.len() * others.len()) as f64;
    for (look, &passes) in budget.looks.iter().enumerate() {
        if open.is_empty() {
            break;
        }
        let is_last = look + 1 == budget.looks.len();
        bdpt.render(subject, passes);
        let mut undecided = Vec::new();
        for (other, mut tiles) in open {
            tiles.render(subject, passes * other.passes);
            let comparison = Comparison::of(&other, &bdpt, &tiles, level);
            if is_last || comparison.is_decided() {
                done.findings.push(comparison.finding(subject, &other, &tiles, level));
                done.p_values.push((other.method, comparison.p_values));
            } else {
                undecided.push((other, tiles));
            }
        }
        open = undecided;
    }
    done
}

/// Tells whether the probabilities of all tiles are as even as those of the same
/// pictures must be: sees a bias that is too small for any one tile.
///
/// The agreements are of one method alone: all are held against the same picture of `bdpt`, so
/// what they find hangs together.
pub fn evenness(method: Method, agreements: &[Agreement]) -> Finding {
    let p_values: Vec<f64> = agreements
        .iter()
        .flat_map(|agreement| &agreement.p_values)
        .filter(|(other, _)| *other == method)
        .flat_map(|(_, p_values)| p_values.iter().copied())
        .collect();
    let p = uniformity(&p_values);
    Finding {
        claim: format!(
            "{method} and bdpt: Welch's probabilities of {} tiles are even",
            p_values.len()
        ),
        statistic: format!("Kolmogorov-Smirnov p = {p:.3}"),
        level: Some(SCENE_LEVEL),
        samples: 0,
        holds: p > SCENE_LEVEL && p_values.len() >= 20,
    }
}

/// Tiles of one rendering: a value a pass.
struct Tiles {
    method: Method,
    side: usize,
    values: Vec<Vec<f64>>,
    /// Tiles whose picture this method can make.
    visible: Vec<bool>,
}

impl Tiles {
    fn new(subject: &Subject<'_>, method: Method, side: usize) -> Self {
        let mut visible = tiles_without_mirrors(subject.scene, side);
        let facts = SceneFacts { mirrors: true, ..SceneFacts::of(subject.scene) };
        if !method.build().blind_spots(&facts).contains(&BlindSpot::SeenInMirrors) {
            visible.fill(true);
        }
        Self { method, side, values: vec![Vec::new(); visible.len()], visible }
    }

    /// Adds passes until there are so many, with numbers of their own.
    fn render(&mut self, subject: &Subject<'_>, passes: u32) {
        let before = self.values[0].len() as u32;
        let place = methods::WALKING.iter().position(|&other| other == self.method);
        let seed = 1 + place.unwrap_or(0) as u64 + 1000 * u64::from(before);
        let settings = Settings { threads: 0, ..settings_by_pass(passes - before, seed) };
        let integrator = self.method.build();
        let (values, side) = (&mut self.values, self.side);
        let statistics = each_pass(subject.scene, integrator.as_ref(), &settings, |pass| {
            let luminance = pass.map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b);
            for (tile, mean) in
                values.iter_mut().zip(tile_means(luminance.values(), luminance.width(), side))
            {
                tile.push(mean);
            }
        });
        assert_eq!(statistics.rejected, 0, "{}, {}", subject.name, self.method);
    }

    fn is_steady(&self, tile: usize) -> bool {
        let values = &self.values[tile];
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares = values.iter().map(|value| (value - mean).powi(2));
        let sum: f64 = squares.clone().sum();
        sum > 0.0 && squares.fold(0.0, f64::max) <= CHANCE * sum
    }

    fn sample(&self, tile: usize) -> Sample {
        Sample::of(&batch_means(&self.values[tile], BATCHES))
    }

    /// Mean over these tiles, a value a pass.
    fn image(&self, keep: &[usize]) -> Sample {
        let mean = |pass: usize| {
            keep.iter().map(|&tile| self.values[tile][pass]).sum::<f64>() / keep.len() as f64
        };
        let means: Vec<f64> = (0..self.values[0].len()).map(mean).collect();
        Sample::of(&batch_means(&means, BATCHES))
    }
}

/// Tiles in which nothing is seen in an ideal mirror.
fn tiles_without_mirrors(scene: &Scene, side: usize) -> Vec<bool> {
    let camera = scene.camera();
    let columns = (camera.width() as usize).div_ceil(side);
    let mut free = vec![true; columns * (camera.height() as usize).div_ceil(side)];
    for y in 0..camera.height() {
        for x in 0..camera.width() {
            let ray = camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
            if scene.intersect(&ray).is_some_and(|point| point.model.has_delta_part()) {
                free[y as usize / side * columns + x as usize / side] = false;
            }
        }
    }
    free
}

/// One method and `bdpt` at one look.
struct Comparison {
    p_values: Vec<f64>,
    refused: bool,
    tiles: usize,
    ratio: f64,
    half_width: f64,
    promise: f64,
}

impl Comparison {
    fn of(other: &Other, bdpt: &Tiles, tiles: &Tiles, level: f64) -> Self {
        let count = tiles.visible.len();
        let visible: Vec<usize> = (0..count).filter(|&tile| tiles.visible[tile]).collect();
        let is_steady = |&tile: &usize| bdpt.is_steady(tile) && tiles.is_steady(tile);
        let keep: Vec<usize> = visible.iter().copied().filter(is_steady).collect();
        let p_values: Vec<f64> =
            keep.iter().map(|&tile| welch(&bdpt.sample(tile), &tiles.sample(tile))).collect();
        let (a, b) = (bdpt.image(&keep), tiles.image(&keep));
        let all = [p_values.as_slice(), &[welch(&a, &b)]].concat();
        let error = (a.variance_of_mean + b.variance_of_mean).sqrt() / a.mean;
        Self {
            refused: holm(&all, level).contains(&true),
            p_values,
            tiles: count,
            ratio: b.mean / a.mean,
            half_width: two_sided_quantile(EQUIVALENCE_LEVEL, (BATCHES - 1) as f64) * error,
            promise: other.promise,
        }
    }

    fn is_equivalent(&self) -> bool {
        (self.ratio - 1.0).abs() + self.half_width <= self.promise
    }

    /// Tells whether half the picture has noise that can be judged.
    fn sees_enough(&self) -> bool {
        2 * self.p_values.len() >= self.tiles
    }

    /// Nothing is decided by the few tiles that are steady early where rare light is still
    /// to come: they are steady because they lack it.
    fn is_decided(&self) -> bool {
        self.sees_enough() && (self.refused || self.is_equivalent())
    }

    fn finding(&self, subject: &Subject<'_>, other: &Other, tiles: &Tiles, level: f64) -> Finding {
        let Self { refused, ratio, half_width, promise, .. } = self;
        let smallest = self.p_values.iter().copied().fold(1.0, f64::min);
        let differs = if *refused { ", a tile or the mean differs" } else { "" };
        let passes = tiles.values[0].len() as u64;
        Finding {
            claim: format!(
                "{}: {} = bdpt within {} % of the mean, and on {} of {} tiles",
                subject.name,
                other.method,
                100.0 * promise,
                self.p_values.len(),
                self.tiles,
            ),
            statistic: format!(
                "ratio {ratio:.5} ± {half_width:.5}, smallest p {smallest:.1e}{differs}"
            ),
            level: Some(level),
            samples: passes * samples_in_a_pass(subject.scene),
            holds: !refused && self.is_equivalent() && self.sees_enough(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shown to differ on so many steady tiles of twelve.
    fn differing(steady: usize) -> Comparison {
        Comparison {
            p_values: vec![1e-20; steady],
            refused: true,
            tiles: 12,
            ratio: 0.9,
            half_width: 0.01,
            promise: 0.05,
        }
    }

    #[test]
    fn a_few_steady_tiles_decide_nothing_early() {
        assert!(!differing(0).is_decided() && !differing(5).is_decided());
        assert!(differing(6).is_decided());
        let same = |steady| Comparison { refused: false, ratio: 1.0, ..differing(steady) };
        assert!(same(6).is_decided() && !same(5).is_decided());
    }
}
