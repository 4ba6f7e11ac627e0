//! Tests whether a method's good average can be relied on.

use super::{Entry, raw_errors};
use crate::picture::{Picture, grey};
use crate::reference::Reference;
use crate::results::{Estimate, Stability};
use traylib_statistics::tail::{FEWER, KEPT, Largest, TailIndex, alarm};
use traylib_statistics::{Sample, quantile};

/// Deviations that noise alone does not reach.
const FAR: f64 = 10.0;
/// The share of the picture's mean that is seen: less does not catch the eye.
const VISIBLE: f64 = 0.1;
/// A deviation known from fewer other runs is so uncertain that noise seems to be
/// ten deviations off more often than in a pixel of a million.
const FEWEST_OTHERS: usize = 15;

pub(super) fn steadiness(entry: &Entry, reference: &Reference) -> Stability {
    let mut largest = Largest::default();
    entry.records.iter().flat_map(|record| &record.largest).for_each(|value| largest.add(*value));
    let many = largest.tail_index(KEPT);
    let errors = raw_errors(entry);
    Stability {
        tail: many.and_then(estimate),
        alarm: alarm(many, largest.tail_index(FEWER)),
        fireflies: fireflies(&entry.pictures, reference),
        worst_over_median: quantile(&errors, 1.0) / quantile(&errors, 0.5),
        rejected: entry.records.iter().map(|record| record.rejected).sum(),
    }
}

fn estimate(index: TailIndex) -> Option<Estimate> {
    Some(Estimate { value: index.alpha?, low: index.lower?, high: index.upper? })
}

/// Pixels per megapixel that are off by more than [`FAR`] deviations of the same
/// pixel in the *other* runs, and by what can be seen. A pixel's own deviation would
/// hide it: one run among sixteen lies at most four deviations off.
fn fireflies(pictures: &[Picture], reference: &Reference) -> Option<f64> {
    if pictures.len() <= FEWEST_OTHERS {
        return None;
    }
    let values = reference.picture.values();
    let visible = VISIBLE * Sample::of(&values.iter().map(grey).collect::<Vec<f64>>()).mean;
    let in_pixel = |pixel: usize| {
        let runs: Vec<f64> = pictures.iter().map(|p| grey(&p.values()[pixel])).collect();
        let right = grey(&values[pixel]);
        let far = |run: &usize| {
            let others: Vec<f64> =
                runs.iter().enumerate().filter(|(i, _)| i != run).map(|(_, v)| *v).collect();
            let Sample { count, variance_of_mean, .. } = Sample::of(&others);
            let deviation = (variance_of_mean * count as f64).sqrt();
            (runs[*run] - right).abs() > (FAR * deviation).max(visible)
        };
        (0..runs.len()).filter(far).count()
    };
    let found: usize = (0..values.len()).map(in_pixel).sum();
    Some(found as f64 * 1e6 / (values.len() * pictures.len()) as f64)
}
