//! Tests whether a reference that nobody has checked can be what the methods render.
//!
//! One of two methods, or a closed form, has been checked; a picture that was given is
//! taken for true. If it is not, the error of a method is no longer its noise: what the
//! reference itself is off by stays, the same in all runs of all methods. The method with
//! the least error shows that best. What stays in a noisier one may be light that is so
//! rare that none of its runs has met it, which is no fault of the reference.

use super::{Entry, curve};
use crate::picture::grey;
use crate::reference::{LARGEST_OWN_SHARE, Reference};
use crate::results::MethodResults;
use traylib_integrators::Method;
use traylib_statistics::{Sample, relative_square_errors, welch};

/// Standard errors that noise does not reach: once in three million scenes.
const SURE: f64 = 5.0;

/// The share of the error that is much, where its pixels are too unlike for their spread to tell
/// how sure it is.
const HIGH_SHARE: f64 = 0.25;

/// The level of Welch's test, once in a million scenes.
const LEVEL: f64 = 1e-6;

/// A picture brighter or darker by less is off by less than 10⁻⁴ in relMSE, a tenth of
/// the least error whose price is asked.
const DARKER: f64 = 0.01;

/// The method whose runs say that the reference is not what they render, if one does;
/// `methods` are the judgements of `entries`.
pub fn doubted_by(
    entries: &[Entry],
    methods: &[MethodResults],
    reference: &Reference,
) -> Option<Method> {
    if reference.checked {
        return None;
    }
    let fit = entries.iter().zip(methods).filter(|(_, m)| !m.biased && !m.stability.alarm);
    let (witness, _) = fit.min_by(|a, b| a.1.metrics.rel_mse.total_cmp(&b.1.metrics.rel_mse))?;
    let doubts = lasting(witness, reference) || brightness(witness, reference);
    doubts.then_some(witness.method)
}

/// Tells whether more of the error stays in all runs than a sure reference may have of its own.
fn lasting(entry: &Entry, reference: &Reference) -> bool {
    let errors = entry.error_map(reference);
    let Some(mean) = curve::mean_picture(&entry.records, &entry.pictures) else { return false };
    let [x, r] = [mean.values(), reference.picture.values()];
    let Some(of_mean) = relative_square_errors(x, r, reference.epsilon) else { return false };
    let runs = entry.records.len() as f64;
    // Of each pixel: the product of the errors of two runs, mean over all pairs.
    let pairs = of_mean.iter().zip(errors.values());
    let lasting: Vec<f64> =
        pairs.map(|(of_mean, of_one)| (runs * of_mean - of_one) / (runs - 1.0)).collect();
    let Sample { mean, variance_of_mean, .. } = Sample::of(&lasting);
    let error = Sample::of(errors.values()).mean;
    if mean > LARGEST_OWN_SHARE * error && mean > SURE * variance_of_mean.sqrt() {
        return true;
    }
    // Where few pixels make most of it, their spread says nothing.
    mean > HIGH_SHARE * error && below_all(entry, reference)
}

/// Tells whether the reference lies below all runs in more pixels than the middle of their law
/// would: noise of light is skewed, so that less than half of it lies above its mean, and
/// all `R` runs do in less than a pixel of 2^R. A reference as noisy as a run is the least
/// of all in one of R + 1.
fn below_all(entry: &Entry, reference: &Reference) -> bool {
    let is_below = |pixel: &usize| {
        let right = grey(&reference.picture.values()[*pixel]);
        entry.pictures.iter().all(|picture| grey(&picture.values()[*pixel]) > right)
    };
    let pixels = reference.picture.values().len();
    let found = (0..pixels).filter(is_below).count() as f64;
    let expected = pixels as f64 * 0.5_f64.powf(entry.pictures.len() as f64);
    // Of a rare event, Poisson's law; and one alone is none.
    found > expected + SURE * expected.sqrt().max(1.0)
}

/// Tells whether the pictures are surely brighter or darker than the reference.
fn brightness(entry: &Entry, reference: &Reference) -> bool {
    let ratios: Vec<f64> = entry.records.iter().map(|record| record.mean_ratio).collect();
    let found = Sample::of(&ratios);
    let one = Sample {
        count: usize::MAX,
        mean: 1.0,
        variance_of_mean: reference.relative_variance_of_mean(),
    };
    (found.mean - 1.0).abs() > DARKER && welch(&found, &one) < LEVEL
}

/// Takes back all that means nothing beside a reference that is wrong: times to an error,
/// and that a point is sure.
pub fn withhold(methods: &mut [MethodResults]) {
    for method in methods {
        method.targets.clear();
        method.points.iter_mut().chain(&mut method.budgets).for_each(|point| point.solid = false);
    }
}
