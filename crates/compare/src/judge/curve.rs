//! Error over time.

use super::{Entry, LEVEL};
use crate::bootstrap;
use crate::picture::Picture;
use crate::reference::Reference;
use crate::results::Point;
use crate::run::{Record, Snapshot};
use traylib_statistics::quantile;

/// After each power of two of passes that every run reached.
pub(super) fn powers_of_two(entry: &Entry, reference: &Reference) -> Vec<Point> {
    (0..u32::BITS)
        .map_while(|level| at(entry, reference, |snapshot| snapshot.passes == 1 << level))
        .collect()
}

/// At each budget that every run was looked at.
pub(super) fn budgets(entry: &Entry, reference: &Reference) -> Vec<Point> {
    let most = entry.records.iter().filter_map(|record| record.snapshots.last()?.budget).max();
    (0..=most.unwrap_or(0))
        .filter_map(|budget| at(entry, reference, |snapshot| snapshot.budget == Some(budget)))
        .collect()
}

/// The snapshots that are wanted, one of each run; `None` if a run has none.
fn at(entry: &Entry, reference: &Reference, wanted: impl Fn(&Snapshot) -> bool) -> Option<Point> {
    let snapshot =
        |record: &Record| record.snapshots.iter().find(|snapshot| wanted(snapshot)).copied();
    let snapshots: Vec<Snapshot> = entry.records.iter().map(snapshot).collect::<Option<_>>()?;
    Some(point(&snapshots, 1, reference))
}

/// Averages 2, 4, … runs: what one run of that length would have come to.
pub(super) fn averaged(entry: &Entry, reference: &Reference) -> Vec<Point> {
    let runs = entry.records.len();
    let sizes = std::iter::successors(Some(2), |size| Some(2 * size));
    let groups = sizes.take_while(|size| *size <= runs).map(|size| {
        let records = entry.records.chunks_exact(size);
        let pictures = entry.pictures.chunks_exact(size);
        let snapshots: Vec<Snapshot> =
            records.zip(pictures).filter_map(|(r, p)| together(r, p, reference)).collect();
        point(&snapshots, size as u32, reference)
    });
    groups.collect()
}

fn together(records: &[Record], pictures: &[Picture], reference: &Reference) -> Option<Snapshot> {
    let mean = mean_picture(records, pictures)?;
    Some(Snapshot {
        passes: records.iter().map(|record| record.passes).sum(),
        seconds: records.iter().map(|record| record.seconds).sum(),
        error: reference.rel_mse(&mean),
        budget: None,
    })
}

/// The mean of runs, each by its passes; `None` without any.
pub(super) fn mean_picture(records: &[Record], pictures: &[Picture]) -> Option<Picture> {
    let passes: f64 = records.iter().map(|record| f64::from(record.passes)).sum();
    let mut mean = pictures.first()?.map(|_| [0.0; 3]);
    for (record, picture) in records.iter().zip(pictures) {
        let share = f64::from(record.passes) / passes;
        for (mean, bands) in mean.values_mut().iter_mut().zip(picture.values()) {
            for (mean, band) in mean.iter_mut().zip(bands) {
                *mean += share * band;
            }
        }
    }
    Some(mean)
}

fn point(snapshots: &[Snapshot], averaged: u32, reference: &Reference) -> Point {
    let errors: Vec<f64> =
        snapshots.iter().map(|snapshot| reference.less_own(snapshot.error)).collect();
    let seconds: Vec<f64> = snapshots.iter().map(|snapshot| snapshot.seconds).collect();
    let error = bootstrap::mean(&errors, LEVEL);
    let passes: f64 = snapshots.iter().map(|snapshot| f64::from(snapshot.passes)).sum();
    Point {
        passes: passes / snapshots.len().max(1) as f64,
        seconds: quantile(&seconds, 0.5),
        error,
        low: quantile(&errors, 0.05),
        high: quantile(&errors, 0.95),
        averaged,
        solid: reference.is_solid_at(error.value),
    }
}
