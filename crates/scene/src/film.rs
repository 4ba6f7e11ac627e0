//! Where light is gathered.

use traylib_math::{Defect, Grid, Rgb, planted};

/// One pass over the whole picture: an estimate of the radiance of each pixel,
/// from its own camera sample and from whatever light paths splatted into it.
#[derive(Clone, Debug)]
pub struct PassImage(Grid<[f64; 3]>);

/// The mean of many passes, and how much they differ.
///
/// Passes are independent of one another; samples within a pass are not, once
/// light paths splat. So the pass is what variance is estimated from.
#[derive(Clone, Debug)]
pub struct Film {
    passes: u32,
    sum: Grid<[f64; 3]>,
    sum_of_squares: Grid<[f64; 3]>,
}

impl PassImage {
    /// A black pass.
    pub fn new(width: u32, height: u32) -> Self {
        Self(Grid::filled(width as usize, height as usize, [0.0; 3]))
    }

    /// Adds radiance to the pixel with this row-major index.
    pub fn add(&mut self, pixel: u32, radiance: Rgb) {
        let sum = &mut self.0.values_mut()[pixel as usize];
        for (sum, band) in sum.iter_mut().zip(radiance.to_array()) {
            *sum += f64::from(band);
            if planted(Defect::SplatsAsAtomics) {
                *sum = f64::from(*sum as f32);
            }
        }
    }

    /// What was added over the number of passes it was added in, as a picture.
    pub fn mean_over(&self, passes: u32) -> Grid<Rgb> {
        let n = f64::from(passes.max(1));
        self.0.map(|sum| Rgb::from(sum.map(|s| (s / n) as f32)))
    }
}

impl Film {
    /// A film without light.
    pub fn new(width: u32, height: u32) -> Self {
        let zero = Grid::filled(width as usize, height as usize, [0.0; 3]);
        Self { passes: 0, sum: zero.clone(), sum_of_squares: zero }
    }

    /// Adds a pass of the same size.
    ///
    /// # Panics
    /// If the sizes differ.
    pub fn add_pass(&mut self, pass: &PassImage) {
        assert_eq!(self.sum.values().len(), pass.0.values().len(), "size of a pass");
        self.passes += 1;
        let totals = self.sum.values_mut().iter_mut().zip(self.sum_of_squares.values_mut());
        for ((sum, squares), value) in totals.zip(pass.0.values()) {
            for band in 0..3 {
                sum[band] += value[band];
                squares[band] += value[band] * value[band];
            }
        }
    }

    /// How many passes there are.
    pub fn passes(&self) -> u32 {
        self.passes
    }

    /// Mean radiance of each pixel, in W/m²/sr; black without passes.
    pub fn mean(&self) -> Grid<[f64; 3]> {
        let n = f64::from(self.passes.max(1));
        self.sum.map(|sum| sum.map(|s| s / n))
    }

    /// The mean as a picture.
    pub fn develop(&self) -> Grid<Rgb> {
        self.mean().map(|mean| Rgb::from(mean.map(|m| m as f32)))
    }

    /// Estimated variance of each pixel's mean; `None` before two passes.
    pub fn variance_of_mean(&self) -> Option<Grid<[f64; 3]>> {
        let n = f64::from(self.passes);
        if self.passes < 2 {
            return None;
        }
        let values = self.sum.values().iter().zip(self.sum_of_squares.values());
        let variances = values
            .map(|(sum, squares)| {
                std::array::from_fn(|band| {
                    let mean = sum[band] / n;
                    (squares[band] / n - mean * mean).max(0.0) / (n - 1.0)
                })
            })
            .collect();
        Grid::from_values(self.sum.width(), self.sum.height(), variances)
    }

    /// Estimated error of the picture: root of the mean variance over the mean
    /// radiance; `None` before two passes or without light.
    pub fn relative_error(&self) -> Option<f64> {
        let total = |grid: &Grid<[f64; 3]>| grid.values().iter().flatten().sum::<f64>();
        let count = 3.0 * self.sum.values().len() as f64;
        let variance = total(&self.variance_of_mean()?) / count;
        let mean = total(&self.sum) / (f64::from(self.passes) * count);
        (mean > 0.0).then(|| variance.sqrt() / mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film_of(values: &[f32]) -> Film {
        let mut film = Film::new(2, 1);
        for &value in values {
            let mut pass = PassImage::new(2, 1);
            pass.add(1, Rgb::splat(value));
            film.add_pass(&pass);
        }
        film
    }

    #[test]
    fn mean_and_variance_are_those_of_the_passes() {
        let film = film_of(&[1.0, 2.0, 6.0]);
        assert_eq!(*film.develop().get(1, 0), Rgb::splat(3.0));
        assert_eq!(*film.develop().get(0, 0), Rgb::BLACK);
        // Sample variance 7, of the mean 7/3.
        let variance = film.variance_of_mean().unwrap().get(1, 0)[0];
        assert!((variance - 7.0 / 3.0).abs() < 1e-12, "{variance}");
        assert!((film.relative_error().unwrap() - (7.0_f64 / 6.0).sqrt() / 1.5).abs() < 1e-12);
    }

    #[test]
    fn one_pass_has_no_variance() {
        assert!(film_of(&[1.0]).variance_of_mean().is_none());
        assert!(film_of(&[]).relative_error().is_none());
        assert!(film_of(&[0.0, 0.0]).relative_error().is_none());
    }

    #[test]
    fn splats_and_samples_of_a_pass_add_up() {
        let mut pass = PassImage::new(1, 1);
        pass.add(0, Rgb::splat(0.5));
        pass.add(0, Rgb::new(0.25, 0.0, 0.0));
        let mut film = Film::new(1, 1);
        film.add_pass(&pass);
        assert_eq!(*film.develop().get(0, 0), Rgb::new(0.75, 0.5, 0.5));
    }
}
