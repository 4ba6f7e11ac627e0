//! The pixels that stand for all.

use super::grid::Grid;
use crate::FoundPath;
use crate::{Chunk, ChunkOutput, Control, Dimensions, Integrator, PointSet, Statistics};
use rayon::prelude::*;
use traylib_math::{Rgb, Sampler};
use traylib_scene::Scene;

/// Words that keep the numbers of a plan apart from those of every picture: what was chosen by
/// numbers must not be rendered with them.
const PLAN: u64 = 0x0070_6c61_6e00;

/// Pixels spread over a film, each asked alone with a light path of its own: together they are
/// a pass of which only a part is rendered, so that a plan sees the picture in its full
/// resolution.
pub(super) struct Probes<'a> {
    pub(super) scene: &'a Scene,
    /// Row-major pixels, one in each cell of a grid over the film.
    pub(super) pixels: Vec<u32>,
    /// The cells of that grid.
    pub(super) grid: Grid,
    seed: u64,
    control: &'a Control,
}

/// The light and paths of one probe in one pass.
#[derive(Debug, Default)]
pub(super) struct Probed {
    /// Light of its camera path.
    pub(super) radiance: Rgb,
    /// Light that its light path threw on any pixel.
    pub(super) splats: Vec<(u32, Rgb)>,
    /// Paths, if they were asked for.
    pub(super) paths: Vec<FoundPath>,
    pub(super) statistics: Statistics,
}

impl<'a> Probes<'a> {
    /// About so many pixels, all if there are fewer, drawn one in each cell of a grid.
    pub(super) fn spread(scene: &'a Scene, count: u32, seed: u64, control: &'a Control) -> Self {
        let (width, height) = (scene.camera().width(), scene.camera().height());
        let seed = traylib_math::sampler::hash(seed, [PLAN, 0, 0]);
        // Cells as square as may be.
        let side = (f64::from(width) * f64::from(height) / f64::from(count)).sqrt().max(1.0);
        let columns = ((f64::from(width) / side).round() as u32).clamp(1, width);
        let rows = ((f64::from(height) / side).round() as u32).clamp(1, height);
        let grid = Grid { columns, rows, width, height };
        let cell = |column: u32, row: u32| {
            let mut sampler = Sampler::new(seed, [1, u64::from(column), u64::from(row)]);
            let x = within(column, columns, width, sampler.next_1d());
            let y = within(row, rows, height, sampler.next_1d());
            y * width + x
        };
        let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let pixels = pixels.map(|(column, row)| cell(column, row)).collect();
        Self { scene, pixels, grid, seed, control }
    }

    /// One of each so many.
    pub(super) fn one_of(&self, many: usize) -> Self {
        let pixels = self.pixels.iter().copied().step_by(many).collect();
        Self { pixels, ..*self }
    }

    /// Asks each for these passes, on all threads; in the order of the probes, pass by pass
    /// within each. Nothing more once the control is cancelled.
    pub(super) fn ask<T: Send>(
        &self,
        integrator: &dyn Integrator,
        points: PointSet,
        passes: u32,
        use_answer: impl Fn(usize, u32, Probed) -> T + Sync,
    ) -> Vec<T> {
        let each_pass = |(number, &pixel): (usize, &u32)| {
            let answer = |pass| {
                let probed = self.probe(integrator, points, pixel, pass, true);
                use_answer(number, pass, probed)
            };
            (0..passes).map(answer).collect::<Vec<T>>()
        };
        self.pixels.par_iter().enumerate().flat_map_iter(each_pass).collect()
    }

    /// The counters of the light path of each probe alone.
    pub(super) fn light_work(&self, integrator: &dyn Integrator, points: PointSet) -> Statistics {
        let counters = |&pixel: &u32| self.probe(integrator, points, pixel, 0, false).statistics;
        let all: Vec<Statistics> = self.pixels.par_iter().map(counters).collect();
        all.into_iter().fold(Statistics::default(), |mut sum, one| {
            sum += one;
            sum
        })
    }

    /// One pixel with its light path, or that alone.
    fn probe(
        &self,
        integrator: &dyn Integrator,
        points: PointSet,
        pixel: u32,
        pass: u32,
        with_camera: bool,
    ) -> Probed {
        let mut out = ChunkOutput::default();
        if self.control.is_cancelled() {
            return Probed::default();
        }
        let all_pixels = self.scene.camera().width() * self.scene.camera().height();
        let light_paths = integrator.light_paths(all_pixels);
        let path = u64::from(pixel) * u64::from(light_paths) / u64::from(all_pixels);
        let path = path as u32;
        let chunk = Chunk {
            seed: self.seed,
            pass: u64::from(pass),
            pixels: pixel..pixel + u32::from(with_camera),
            light_paths: path..path + u32::from(light_paths > 0),
            light_path_count: light_paths,
            points,
            dimensions: Dimensions::of(self.scene),
            control: self.control,
        };
        integrator.render_chunk(self.scene, &chunk, &mut out);
        let mut probed =
            Probed { paths: out.paths, statistics: out.statistics, ..Probed::default() };
        for (lit, light) in out.light {
            if lit == pixel {
                probed.radiance += light;
            } else {
                probed.splats.push((lit, light));
            }
        }
        probed
    }
}

/// A place in one of `parts` equal parts of `0..whole`.
fn within(part: u32, parts: u32, whole: u32, u: f32) -> u32 {
    let (from, to) = (Grid::edge(part, parts, whole), Grid::edge(part + 1, parts, whole));
    (from + (u * (to - from) as f32) as u32).min(to - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Method;

    /// Trials have numbers of their own: else the picture would be rendered with the samples that
    /// it was chosen by.
    #[test]
    fn a_plan_draws_no_sample_of_its_picture() {
        let (scene, control, seed) = (crate::bdpt::room(), Control::default(), 7);
        let method = Method::COMBINED.build();
        let probes = Probes::spread(&scene, 256, seed, &control);
        let of_picture = Probes { seed, pixels: probes.pixels.clone(), ..probes };
        for points in PointSet::ALL {
            let [planned, drawn] = [&probes, &of_picture]
                .map(|probes| probes.ask(&*method, points, 2, |_, _, probed| probed.radiance));
            let lit = drawn.iter().filter(|radiance| !radiance.is_black()).count();
            let pairs = planned.iter().zip(&drawn);
            let alike = pairs.filter(|(a, b)| a == b && !a.is_black()).count();
            assert!(lit > 300 && 10 * alike < lit, "{points}: {alike} of {lit} alike");
        }
    }

    #[test]
    fn places_lie_in_their_parts() {
        for (whole, parts) in [(10, 3), (7, 7), (640, 37)] {
            let mut before = None;
            for part in 0..parts {
                let ends = [0.0, 0.999_999_94].map(|u| within(part, parts, whole, u));
                assert!(before < Some(ends[0]) && ends[0] <= ends[1] && ends[1] < whole);
                before = Some(ends[1]);
            }
        }
    }
}
