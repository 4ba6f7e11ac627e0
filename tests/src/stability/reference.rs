//! References: what the cells of a row are held against.

use crate::stability::scene::{FailureScene, Truth};
use traylib_geometry::Vec3;
use traylib_integrators::Method;
use traylib_known::{each_pass, settings_by_pass};
use traylib_math::{Grid, Vec2};
use traylib_scene::{Camera, Scene};
use traylib_statistics::{error_floor, own_rel_mse, rel_mse};

/// A seed of no cell.
const SEED: u64 = 0x7EF;

/// Points in a pixel, along each side, that a closed form is averaged over.
const STEPS: u32 = 8;

/// The picture as it should be, row by row; each value the mean of the bands.
#[derive(Clone, Debug)]
pub struct Reference {
    /// One a pixel.
    pub pixels: Vec<f64>,
    /// Variance of each; zeros for a closed form.
    pub variances: Vec<f64>,
    /// Columns of the picture.
    pub width: usize,
}

impl Reference {
    /// Makes the reference of this row.
    pub fn of(row: &FailureScene, scene: &Scene) -> Self {
        match row.truth {
            Truth::Closed(radiance) => Self::closed(scene.camera(), radiance),
            Truth::Rendered(by, passes) => Self::rendered(row, scene, by, passes),
        }
    }

    fn closed(camera: &Camera, radiance: fn(Vec3, Vec3) -> f64) -> Self {
        let (width, height) = (camera.width(), camera.height());
        let pixel = |i: u32| {
            let corner = Vec2::new((i % width) as f32, (i / width) as f32);
            mean_over_pixel(camera, corner, radiance)
        };
        let pixels: Vec<f64> = (0..width * height).map(pixel).collect();
        Self { variances: vec![0.0; pixels.len()], pixels, width: width as usize }
    }

    fn rendered(row: &FailureScene, scene: &Scene, by: Method, passes: u32) -> Self {
        let integrator = by.up_to(row.max_depth).build();
        let settings = settings_by_pass(passes, SEED);
        let size = (scene.camera().width() * scene.camera().height()) as usize;
        let (mut sums, mut squares) = (vec![0.0; size], vec![0.0; size]);
        each_pass(scene, integrator.as_ref(), &settings, |pass| {
            for ((sum, square), value) in sums.iter_mut().zip(&mut squares).zip(values(&pass)) {
                *sum += value;
                *square += value * value;
            }
        });
        let n = f64::from(passes);
        let pixels: Vec<f64> = sums.iter().map(|sum| sum / n).collect();
        let variance =
            |(square, mean): (&f64, &f64)| (square / n - mean * mean).max(0.0) / (n - 1.0);
        let variances = squares.iter().zip(&pixels).map(variance).collect();
        Self { pixels, variances, width: scene.camera().width() as usize }
    }

    /// Mean of the picture.
    pub fn mean(&self) -> f64 {
        self.pixels.iter().sum::<f64>() / self.pixels.len() as f64
    }

    /// Variance of that, as if pixels were independent; light paths splat into
    /// few pixels each, so they nearly are.
    pub fn variance_of_mean(&self) -> f64 {
        self.variances.iter().sum::<f64>() / (self.pixels.len() as f64).powi(2)
    }

    /// Returns what the square of an error in each pixel is divided by for relMSE: r² + ε.
    pub fn scales(&self) -> Vec<f64> {
        let floor = self.floor();
        self.pixels.iter().map(|pixel| pixel * pixel + floor).collect()
    }

    /// relMSE of a picture against this one.
    pub fn rel_mse(&self, picture: &[f64]) -> f64 {
        rel_mse(grey(picture), grey(&self.pixels), self.floor())
    }

    /// Returns what this reference's own noise adds to every relMSE.
    pub fn own_rel_mse(&self) -> f64 {
        own_rel_mse(grey(&self.pixels), grey(&self.variances), self.floor())
    }

    fn floor(&self) -> f64 {
        error_floor(grey(&self.pixels))
    }
}

/// Pixels of one band.
fn grey(values: &[f64]) -> &[[f64; 1]] {
    values.as_chunks().0
}

/// The mean of the three bands, pixel by pixel.
pub fn values(pass: &Grid<[f64; 3]>) -> impl Iterator<Item = f64> + '_ {
    pass.values().iter().map(|bands| bands.iter().sum::<f64>() / 3.0)
}

fn mean_over_pixel(camera: &Camera, corner: Vec2, radiance: fn(Vec3, Vec3) -> f64) -> f64 {
    let sum: f64 = (0..STEPS * STEPS)
        .map(|i| {
            let inside = Vec2::new((i % STEPS) as f32 + 0.5, (i / STEPS) as f32 + 0.5);
            let direction = camera.ray(corner + inside / STEPS as f32).direction;
            radiance(camera.position(), direction)
        })
        .sum();
    sum / f64::from(STEPS * STEPS)
}
