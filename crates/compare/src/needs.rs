//! Measures what a scene needs: one part at a time is taken away from bidirectional tracing or
//! from the surfaces, and what that saves in time is held against what it costs in error.

mod part;
mod text;

pub use part::{Part, Rest};
pub use text::table;

use std::fmt::Display;
use traylib_demos::Failure;
use traylib_integrators::{Settings, render_to_end};
use traylib_known::cost::seconds_per_pass;
use traylib_math::Grid;
use traylib_scene::Scene;
use traylib_statistics::Sample;

/// The amount of rendering that goes into the measurement.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Pictures with each set of parts, of seeds of their own.
    pub pictures: u32,
    /// Samples a pixel of each.
    pub spp: u32,
    /// Threads; 0 for one a processor.
    pub threads: usize,
}

/// The needs of a scene, as they were found.
#[derive(Clone, Debug)]
pub struct Needs {
    /// With all parts.
    pub whole: Measured,
    /// Without each of them.
    pub without: Vec<(Part, Measured)>,
}

/// The figures of bidirectional tracing with some of its parts.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Nanoseconds of a sample on one thread.
    pub nanoseconds: f64,
    /// Variance of one sample, relative as relMSE is.
    pub noise: f64,
    /// Mean of the picture, with its standard error.
    pub mean: (f64, f64),
    /// relMSE that would stay however long it rendered, with its standard error.
    pub bias: (f64, f64),
}

impl Measured {
    /// Returns what it takes to reach an error, but for a factor that all have in common.
    pub fn cost(&self) -> f64 {
        self.noise * self.nanoseconds
    }
}

/// Some pictures of the same.
struct Pictures {
    mean: Grid<[f64; 3]>,
    /// Mean square of the difference between pictures, of each band.
    variance: Grid<[f64; 3]>,
    means: Vec<f64>,
    nanoseconds: f64,
}

/// Measures all that can be taken away on a scene; `tell` hears of each beforehand.
///
/// # Errors
/// The system refuses threads, or there is no room for the scene once more.
pub fn needs(scene: &Scene, effort: Effort, tell: &dyn Fn(&dyn Display)) -> Result<Needs, Failure> {
    tell(&"the whole");
    let whole = pictures(&Rest::whole(scene), effort)?;
    let measured = whole.against(&whole, effort);
    let without = Part::of(scene).into_iter().map(|part| {
        tell(&part);
        let rest = part.taken_from(scene).map_err(Failure::output)?;
        Ok((part, pictures(&rest, effort)?.against(&whole, effort)))
    });
    Ok(Needs { whole: measured, without: without.collect::<Result<_, Failure>>()? })
}

fn pictures(rest: &Rest, effort: Effort) -> Result<Pictures, Failure> {
    let Rest { scene, integrator, points } = rest;
    let Effort { pictures, spp, threads } = effort;
    let rendered = (0..u64::from(pictures)).map(|seed| {
        let settings = Settings { spp, seed, threads, points: *points };
        let rendered = render_to_end(scene, integrator, &settings).map_err(Failure::output)?;
        Ok(rendered.film.mean())
    });
    let rendered: Vec<Grid<[f64; 3]>> = rendered.collect::<Result<_, Failure>>()?;
    let n = rendered.len() as f64;
    let mut mean = rendered[0].map(|_| [0.0; 3]);
    let mut variance = mean.clone();
    for picture in &rendered {
        add(&mut mean, picture, |_, value| value / n);
    }
    for picture in &rendered {
        let mean = mean.clone();
        add(&mut variance, picture, |i, value| {
            (value - mean.values()[i / 3][i % 3]).powi(2) / (n - 1.0)
        });
    }
    let pixels = f64::from(scene.camera().width() * scene.camera().height());
    Ok(Pictures {
        mean,
        variance,
        means: rendered.iter().map(grey_mean).collect(),
        nanoseconds: 1e9 * seconds_per_pass(scene, integrator) / pixels,
    })
}

/// Adds something of each band, which are numbered over the whole picture.
fn add(sum: &mut Grid<[f64; 3]>, of: &Grid<[f64; 3]>, term: impl Fn(usize, f64) -> f64) {
    let bands = sum.values_mut().iter_mut().flatten().zip(of.values().iter().flatten());
    for (i, (sum, value)) in bands.enumerate() {
        *sum += term(i, *value);
    }
}

fn grey_mean(picture: &Grid<[f64; 3]>) -> f64 {
    let all = picture.values().iter().flatten();
    all.sum::<f64>() / (3 * picture.values().len()) as f64
}

impl Pictures {
    /// The numbers of these pictures, errors relative to the light of the whole.
    fn against(&self, whole: &Self, effort: Effort) -> Measured {
        let n = f64::from(effort.pictures);
        let mean = grey_mean(&whole.mean);
        let epsilon = 0.01 * mean * mean;
        let bands = |of: &Self, pixel: usize, band: usize| {
            (of.mean.values()[pixel][band], of.variance.values()[pixel][band])
        };
        let (mut noise, mut bias, mut count, mut bias_variance) = (0.0, 0.0, 0.0, 0.0);
        for pixel in 0..whole.mean.values().len() {
            let mut deviation = 0.0;
            for band in 0..3 {
                let ((own, variance), (r, of_whole)) =
                    (bands(self, pixel, band), bands(whole, pixel, band));
                let unit = r * r + epsilon;
                noise += variance / unit;
                // Without what the noise of both means adds to their difference.
                let of_both = (variance + of_whole) / n;
                bias += ((own - r).powi(2) - of_both) / unit;
                // Of a difference that is nothing but noise: of its square and of what is taken
                // off, which n pictures tell. Bands of a pixel rise and fall together.
                deviation += (2.0 * n / (n - 1.0)).sqrt() * of_both / unit;
                count += 1.0;
            }
            bias_variance += deviation * deviation;
        }
        let sample = Sample::of(&self.means);
        Measured {
            nanoseconds: self.nanoseconds,
            noise: f64::from(effort.spp) * noise / count,
            mean: (sample.mean, sample.variance_of_mean.sqrt()),
            bias: (bias / count, bias_variance.sqrt() / count),
        }
    }
}
