//! Sums over passes that lie side by side.

use super::pass_image::{PassImage, black};
use std::collections::BTreeMap;
use std::ops::Range;
use traylib_math::Grid;

/// Sums over 2ᵏ passes, the first of which has a multiple of 2ᵏ as its number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Block {
    first: u64,
    passes: u64,
    sum: Grid<[f64; 3]>,
    /// Of the passes, not of the samples: samples of a pass depend on one another. A single
    /// pass does without.
    squares: Option<Grid<[f64; 3]>>,
    layers: BTreeMap<u16, Grid<[f64; 3]>>,
}

impl Block {
    pub(super) fn of_pass(number: u32, pass: PassImage) -> Self {
        let PassImage { light, layers } = pass;
        Self { first: number.into(), passes: 1, sum: light, squares: None, layers }
    }

    /// The numbers of its passes.
    pub(super) fn passes(&self) -> Range<u64> {
        self.first..self.first + self.passes
    }

    /// Where the block begins with which it makes one of twice its size.
    pub(super) fn sibling(&self) -> u64 {
        self.first ^ self.passes
    }

    /// Whether both make one block, this one first.
    pub(super) fn joins(&self, next: &Self) -> bool {
        self.passes == next.passes && self.sibling() == next.first && self.first < next.first
    }

    /// Adds the passes of the block that comes after it.
    pub(super) fn join(&mut self, next: &Self) {
        let mut squares = self.squares.take().unwrap_or_else(|| self.sum.map(|&sum| square(sum)));
        match &next.squares {
            Some(next) => add(&mut squares, next.values().iter().copied()),
            None => add(&mut squares, next.sum.values().iter().map(|&sum| square(sum))),
        }
        self.squares = Some(squares);
        add(&mut self.sum, next.sum.values().iter().copied());
        let (width, height) = (self.sum.width(), self.sum.height());
        for (&number, layer) in &next.layers {
            let sum = self.layers.entry(number).or_insert_with(|| black(width, height));
            add(sum, layer.values().iter().copied());
        }
        self.passes += next.passes;
    }

    /// The sums of a pixel, and of the squares.
    pub(super) fn pixel(&self, index: usize) -> ([f64; 3], [f64; 3]) {
        let sum = self.sum.values()[index];
        (sum, self.squares.as_ref().map_or_else(|| square(sum), |s| s.values()[index]))
    }

    /// The sums alone.
    pub(super) fn into_sum(self) -> Grid<[f64; 3]> {
        self.sum
    }

    /// The sum of a pixel of a layer.
    pub(super) fn layer_pixel(&self, number: u16, index: usize) -> [f64; 3] {
        self.layers.get(&number).map_or([0.0; 3], |layer| layer.values()[index])
    }

    /// The numbers of the layers into which light fell.
    pub(super) fn layers(&self) -> impl Iterator<Item = u16> {
        self.layers.keys().copied()
    }
}

fn square(values: [f64; 3]) -> [f64; 3] {
    values.map(|value| value * value)
}

fn add(sums: &mut Grid<[f64; 3]>, values: impl Iterator<Item = [f64; 3]>) {
    for (sum, value) in sums.values_mut().iter_mut().zip(values) {
        for (sum, value) in sum.iter_mut().zip(value) {
            *sum += value;
        }
    }
}
