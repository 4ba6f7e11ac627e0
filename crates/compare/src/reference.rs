//! References: what pictures are held against, and how sure it is itself.

mod agreement;
mod method_reference;
mod pair;

pub use method_reference::MethodReference;
pub use pair::{Making, find, make};

use crate::picture::Picture;
use crate::results::ReferenceResults;
use traylib_math::Grid;
use traylib_statistics::{error_floor, own_rel_mse, rel_mse};

/// A reference's own error may be this share of what it measures.
pub(crate) const LARGEST_OWN_SHARE: f64 = 0.05;

/// The picture as it should be.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Mean radiance of each pixel.
    pub picture: Picture,
    /// Variance of each of these; zeros for a closed form.
    pub variance: Picture,
    /// ε of relMSE.
    pub epsilon: f64,
    /// True if it is known to be right: a closed form, or compared with another method.
    pub checked: bool,
    /// The figures that are told of it.
    pub results: ReferenceResults,
}

impl Reference {
    /// From a picture and its variance.
    pub(crate) fn new(picture: Picture, variance: Picture, results: ReferenceResults) -> Self {
        let epsilon = error_floor(picture.values());
        let own_error = own_rel_mse(picture.values(), variance.values(), epsilon);
        let results = ReferenceResults { own_error, ..results };
        Self { picture, variance, epsilon, checked: true, results }
    }

    /// Makes a reference of the same radiance everywhere.
    pub fn constant(width: usize, height: usize, radiance: f64) -> Self {
        let origin = format!("a closed form: {radiance} W/m²/sr everywhere");
        let picture = Grid::filled(width, height, [radiance; 3]);
        Self { checked: true, ..Self::given(picture, origin) }
    }

    /// A picture from elsewhere, taken for true.
    pub fn given(picture: Picture, origin: String) -> Self {
        let variance = picture.map(|_| [0.0; 3]);
        let results = ReferenceResults {
            origin,
            own_error: 0.0,
            seconds: 0.0,
            agreement: None,
            doubted_by: None,
        };
        Self { checked: false, ..Self::new(picture, variance, results) }
    }

    /// relMSE of a picture of the same size; its own noise is in it.
    pub fn rel_mse(&self, picture: &Picture) -> f64 {
        rel_mse(picture.values(), self.picture.values(), self.epsilon)
    }

    /// An error without the reference's own noise. Where that is nearly all of it,
    /// a hundredth is left: nothing is known, and the point is hollow, but a
    /// logarithm exists.
    pub fn less_own(&self, error: f64) -> f64 {
        (error - self.results.own_error).max(0.01 * error).max(f64::MIN_POSITIVE)
    }

    /// Tells whether it is good enough to measure such an error.
    pub fn is_solid_at(&self, error: f64) -> bool {
        self.results.own_error < LARGEST_OWN_SHARE * error
    }

    /// Says why no picture can be held against it; `None` if one can: an error that is relative to
    /// its light has to have light.
    pub fn nothing_to_compare(&self) -> Option<String> {
        let origin = &self.results.origin;
        let values = self.picture.values().as_flattened();
        if values.iter().any(|value| !value.is_finite()) {
            return Some(format!("the reference ({origin}) has values that are not finite"));
        }
        values.iter().all(|value| *value == 0.0).then(|| {
            format!("the reference is black ({origin}), and no error is relative to no light")
        })
    }

    /// Relative variance of the picture's mean, as if pixels were independent, which
    /// they nearly are.
    pub fn relative_variance_of_mean(&self) -> f64 {
        let total: f64 = self.picture.values().iter().flatten().sum();
        // Bands of a pixel rise and fall together: their deviations add.
        let pixel = |v: &[f64; 3]| v.iter().map(|v| v.sqrt()).sum::<f64>().powi(2);
        let variance: f64 = self.variance.values().iter().map(pixel).sum();
        if total > 0.0 { variance / (total * total) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_closed_form_is_sure_of_itself() {
        let reference = Reference::constant(4, 3, 2.0);
        assert!((reference.epsilon - 0.04).abs() < 1e-12);
        assert!(reference.is_solid_at(1e-9));
        let off = Grid::filled(4, 3, [2.2, 2.0, 1.8]);
        let expected = (0.04 + 0.04) / 3.0 / 4.04;
        assert!((reference.rel_mse(&off) - expected).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_light_compares_nothing() {
        let reason = |radiance| Reference::constant(4, 3, radiance).nothing_to_compare();
        assert!(reason(0.0).unwrap().starts_with("the reference is black (a closed form"));
        assert!(reason(f64::NAN).unwrap().contains("not finite"));
        assert_eq!(reason(1e-30), None);
    }

    #[test]
    fn noise_of_a_reference_is_told() {
        let picture = Grid::filled(2, 2, [1.0; 3]);
        let results = Reference::constant(2, 2, 1.0).results;
        let noisy = Reference::new(picture.clone(), picture.map(|_| [0.0101; 3]), results);
        assert!((noisy.results.own_error - 0.01).abs() < 1e-12);
        assert!(!noisy.is_solid_at(0.1) && noisy.is_solid_at(0.3));
        // Four pixels, each with a variance of 0.0101 in equal bands.
        assert!((noisy.relative_variance_of_mean() - 0.0101 / 4.0).abs() < 1e-12);
    }
}
