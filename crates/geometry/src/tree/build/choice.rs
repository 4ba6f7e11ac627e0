//! The choice of the neighbour with which a box makes the smallest one.

use super::bounds::Bounds;
use crate::tree::parallel;

/// Boxes a task; the columns of so many are near the processor.
const CHUNK: usize = 512;

/// Writes for each of two boxes or more the one at most `radius` places away that
/// gives the union of least area. `bounds` knows the boxes.
///
/// Of equal areas that with the least exclusive or of the two places counts, so
/// that equal boxes pair up: 0 with 1, 2 with 3.
pub(super) fn nearest(choices: &mut [u32], radius: usize, bounds: impl Fn(usize) -> Bounds + Sync) {
    let count = choices.len();
    let tasks = choices.chunks_mut(CHUNK).enumerate().collect();
    parallel::run(tasks, |(chunk, out): (usize, &mut [u32])| {
        let first = chunk * CHUNK;
        let start = first.saturating_sub(radius);
        let end = count.min(first + out.len() + radius);
        let best = Columns::of((start..end).map(&bounds)).best(start, radius);
        for ((i, choice), key) in (first..).zip(out).zip(&best[first - start..]) {
            *choice = i as u32 ^ key.to_bits() as u32;
        }
    });
}

/// Neighbours as they come: 0 with 1, 2 with 3; the last may be left alone.
pub(super) fn next(choices: &mut [u32]) {
    let count = choices.len();
    let tasks = choices.chunks_mut(CHUNK).enumerate().collect();
    parallel::run(tasks, |(chunk, out): (usize, &mut [u32])| {
        for (i, choice) in (chunk * CHUNK..).zip(out) {
            *choice = if i ^ 1 < count { i ^ 1 } else { i } as u32;
        }
    });
}

/// Neighbouring boxes, each coordinate by itself, so that several are taken at once.
struct Columns {
    low: [Vec<f32>; 3],
    high: [Vec<f32>; 3],
    len: usize,
}

impl Columns {
    fn of(boxes: impl ExactSizeIterator<Item = Bounds>) -> Self {
        let len = boxes.len();
        let [mut low, mut high] = [0; 2].map(|_| [0; 3].map(|_| vec![0.0; len]));
        for (i, bounds) in boxes.enumerate() {
            let (min, max) = bounds.corners();
            for axis in 0..3 {
                (low[axis][i], high[axis][i]) = (min[axis], max[axis]);
            }
        }
        Self { low, high, len }
    }

    /// The least key of each box, of which the first is number `start`.
    fn best(&self, start: usize, radius: usize) -> Vec<f64> {
        let mut best = vec![f64::INFINITY; self.len];
        let mut areas = vec![0.0; self.len];
        let mut keys = vec![0.0; self.len];
        for distance in 1..=radius.min(self.len - 1) {
            let pairs = self.len - distance;
            self.areas(distance, &mut areas[..pairs]);
            fill(&mut keys[..pairs], &areas[..pairs], start, distance);
            // Every pair is looked at once, and counts for both.
            lower(&mut best[..pairs], &keys);
            lower(&mut best[distance..], &keys);
        }
        best
    }

    /// Computes the area of each box and the one at this distance together.
    fn areas(&self, distance: usize, areas: &mut [f32]) {
        let count = areas.len();
        let [low_a, high_a] = [&self.low, &self.high].map(|columns| part(columns, 0, count));
        let [low_b, high_b] = [&self.low, &self.high].map(|columns| part(columns, distance, count));
        for (i, area) in areas.iter_mut().enumerate() {
            let extent = |axis: usize| {
                let (a, b) = (low_a[axis][i], low_b[axis][i]);
                let (c, d) = (high_a[axis][i], high_b[axis][i]);
                // In this form each is one instruction.
                (if c > d { c } else { d }) - if a < b { a } else { b }
            };
            let [x, y, z] = [extent(0), extent(1), extent(2)];
            let sum = x * y + y * z + z * x;
            // As the areas of `Bounds`.
            *area = if sum < f32::MAX { sum } else { f32::MAX };
        }
    }
}

/// Returns `count` numbers of each column, from `first` on.
fn part(columns: &[Vec<f32>; 3], first: usize, count: usize) -> [&[f32]; 3] {
    columns.each_ref().map(|column| &column[first..first + count])
}

/// The keys of all pairs at this distance.
fn fill(keys: &mut [f64], areas: &[f32], start: usize, distance: usize) {
    for (i, (out, area)) in keys.iter_mut().zip(areas).enumerate() {
        let place = (start + i) as u32;
        *out = key(*area, place ^ place.wrapping_add(distance as u32));
    }
}

/// Ordered as the areas are, which are not negative, then as the differences.
///
/// The bits of numbers that are not negative are ordered as the numbers are; of
/// numbers, unlike of long integers, every processor finds several minima at once.
#[inline]
fn key(area: f32, difference: u32) -> f64 {
    f64::from_bits(u64::from(area.to_bits()) << 32 | u64::from(difference))
}

fn lower(best: &mut [f64], keys: &[f64]) {
    for (best, &key) in best.iter_mut().zip(keys) {
        *best = if key < *best { key } else { *best };
    }
}
